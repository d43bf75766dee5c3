// SPDX-License-Identifier: Apache-2.0
// The room `base`: what every other room may use. Seeds and random streams, clocks, owned handles, files, threads, the
// log. Nothing here knows what the program is about, and it includes no other room.
#pragma once
#include <chrono>

namespace quadrat::base {

// A moment since the program started.
using Instant = std::chrono::nanoseconds;

// The only place where the program learns what time it is; everything else is told.
class Clock {
  public:
    virtual ~Clock() = default;
    virtual Instant now() = 0;
    // Simulated clocks go there at once; a real one ignores it.
    virtual void skip_to(Instant) {}
    virtual bool is_simulated() const { return false; }
};

class SteadyClock : public Clock {
  public:
    Instant now() override { return std::chrono::steady_clock::now() - start_; }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Runs `speed` times as fast as the world, for tests of endurance.
class HastyClock : public Clock {
  public:
    explicit HastyClock(double speed) : speed_(speed) {}
    Instant now() override {
        return Instant{static_cast<Instant::rep>(static_cast<double>(steady_.now().count()) * speed_)};
    }

  private:
    SteadyClock steady_;
    double speed_;
};

class SimulatedClock : public Clock {
  public:
    Instant now() override { return now_; }
    void skip_to(Instant at) override {
        if (at > now_) now_ = at;
    }
    bool is_simulated() const override { return true; }

  private:
    Instant now_{0};
};

}  // namespace quadrat::base
