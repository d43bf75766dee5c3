// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <deque>
#include <functional>
#include <map>
#include <string>

#include "display/kms/screen_hardware.hpp"

namespace quadrat::display::testing {

// A card, a cable, a screen and a clock that do what a test says, when it says so. Nothing takes time but waiting.
class ScriptedScreen final : public ScreenHardware {
  public:
    // The world as it stands.
    bool has_card = true;
    bool is_connected = true;
    bool is_link_bad = false;
    bool is_denied = false;
    std::uint64_t edid = 77;
    int rungs = 4;
    bool are_flips_lost = false;
    bool is_context_lost = false;
    std::deque<Refusal> modeset_answers;  // one a call; then None
    std::deque<Refusal> flip_answers;
    Refusal every_modeset = Refusal::None;  // when the list is empty
    Refusal every_flip = Refusal::None;
    Instant flip_skew{0};  // added to the time that a flip reports

    // What was done, in order: "probe", "glance", "modeset 0", "disable", "close", "flip".
    std::vector<std::string> journal;
    int count(const std::string& what) const;

    // Later: at that moment of the clock, while somebody waits.
    void at(Instant moment, std::function<void(ScriptedScreen&)> happens) {
        script_.emplace(moment, std::move(happens));
    }
    void tell(News news) { news_.push_back(std::move(news)); }
    void plug_in() {
        is_connected = true;
        tell(event::PlugMoved{false});
    }
    void unplug() {
        is_connected = false;
        tell(event::PlugMoved{true});
    }

    void spend(Instant time) { now_ += time; }  // on drawing, say; the news of it wait

    Instant now() override { return now_; }
    std::vector<News> wait(Instant at_most) override;
    ProbeResult probe() override;
    std::optional<event::PlugMoved> glance() override;
    Refusal modeset(int rung) override;
    void disable() override;
    void close_card() override;
    std::optional<Refusal> flip() override;
    Instant period() const override { return kPeriod; }

    static constexpr Instant kPeriod{16'666'667};

  private:
    Refusal next_answer(std::deque<Refusal>& answers, Refusal otherwise);
    Instant now_{1'000'000'000};
    std::multimap<Instant, std::function<void(ScriptedScreen&)>> script_;
    std::optional<Instant> flip_ends_at_;
    std::vector<News> news_;
};

}  // namespace quadrat::display::testing
