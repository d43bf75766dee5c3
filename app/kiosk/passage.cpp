// SPDX-License-Identifier: Apache-2.0
#include "kiosk/passage.hpp"

#include <algorithm>
#include <thread>

namespace quadrat::kiosk {
namespace {

class Real : public Passage {
  public:
    bool waits_for_all() const override { return false; }
    void pass(base::Instant, std::optional<base::Instant>, base::Instant rest) override {
        std::this_thread::sleep_for(rest);
    }
};

class Simulated : public Passage {
  public:
    explicit Simulated(base::Clock& clock) : clock_(clock) {}
    bool waits_for_all() const override { return true; }
    // A wish that was granted can change what comes next at once: never skip while something waits.
    void pass(base::Instant now, std::optional<base::Instant> next_moment, base::Instant) override {
        clock_.skip_to(std::max(now + std::chrono::milliseconds{1}, next_moment.value_or(now)));
    }

  private:
    base::Clock& clock_;
};

}  // namespace

std::unique_ptr<Passage> passage_of(base::Clock& clock) {
    if (clock.is_simulated()) return std::make_unique<Simulated>(clock);
    return std::make_unique<Real>();
}

}  // namespace quadrat::kiosk
