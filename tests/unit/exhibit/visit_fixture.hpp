// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <utility>
#include <vector>

#include "exhibit/visit.hpp"

namespace quadrat::exhibit {

template <typename W>
const W* wish_in(const std::vector<Wish>& wishes) {
    for (const Wish& wish : wishes)
        if (const auto* found = std::get_if<W>(&wish)) return found;
    return nullptr;
}

inline genome::Pick pick_of(std::optional<std::size_t> trees, std::optional<std::size_t> land,
                            std::optional<std::size_t> sky) {
    genome::Pick pick;
    pick.each = {trees, land, sky};
    return pick;
}

// A visitor with a clock in their pocket, and an exhibit that grows as fast as it is told to.
class Visitor {
  public:
    explicit Visitor(const Timings& timings = {}) : timings_(timings) { take(opening(now_)); }

    Visitor& wait(std::chrono::milliseconds time) {
        now_ += time;
        send(Tick{});
        return *this;
    }
    Visitor& press(Choice button) {
        now_ += std::chrono::milliseconds(400);
        send(Pressed{button});
        now_ += std::chrono::milliseconds(100);
        return send(Released{button});
    }
    Visitor& hold(Choice button, std::chrono::milliseconds time) {
        now_ += std::chrono::milliseconds(400);
        send(Pressed{button});
        wait(time);
        return send(Released{button});
    }
    Visitor& grown() { return send(GenerationReady{state_.generation}); }
    Visitor& send(const Event& event) {
        take(next(state_, event, now_, timings_));
        return *this;
    }
    // From Attract to the first question.
    Visitor& arrive() { return grown().press(Choice::A); }
    Visitor& whole_round(Choice trees = Choice::A, Choice land = Choice::B, Choice sky = Choice::C) {
        return press(trees).press(land).press(sky).grown();
    }

    const State& state() const { return state_; }
    Screen screen() const { return state_.screen; }
    Instant now() const { return now_; }
    const Timings& timings() const { return timings_; }
    const std::vector<Wish>& wishes() const { return wishes_; }  // of the last event that had any
    template <typename W>
    const W* wished() const {
        return wish_in<W>(wishes_);
    }

  private:
    void take(Step step) {
        state_ = std::move(step.state);
        if (!step.wishes.empty()) wishes_ = std::move(step.wishes);
    }

    Timings timings_;
    Instant now_{std::chrono::seconds(1000)};
    State state_;
    std::vector<Wish> wishes_;
};

}  // namespace quadrat::exhibit
