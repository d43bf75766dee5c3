// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <utility>
#include <vector>

#include "exhibit/visit.hpp"
#include "switches/switches.hpp"

namespace quadrat::switches {

// Somebody with one button or two before a visit, both on a clock of their own; what is asked to grow stands at once.
class Player {
  public:
    explicit Player(const Options& options, exhibit::Timings timings = {}) : options_(options), usual_(timings) {
        visit_ = exhibit::opening(now_).state;
        tell(exhibit::GenerationReady{visit_.generation});
        tick();
    }

    // In steps of a frame, as the loop does.
    Player& wait(std::chrono::milliseconds time) {
        for (const Instant until = now_ + time; now_ < until;) {
            now_ += std::min(Instant(std::chrono::milliseconds(20)), until - now_);
            tick();
        }
        return *this;
    }
    Player& press(Choice button) { return hold(button, std::chrono::milliseconds(100)); }
    Player& hold(Choice button, std::chrono::milliseconds time) { return down(button).wait(time).up(button); }
    Player& down(Choice button) { return hear(exhibit::Pressed{button}); }
    Player& up(Choice button) { return hear(exhibit::Released{button}); }
    // Until this is marked, as somebody waits who wants it; gives up after a minute.
    Player& until_marked(Choice choice) {
        for (int frames = 0; state_.marked != choice && frames < 3000; ++frames) wait(std::chrono::milliseconds(20));
        return *this;
    }
    // One button: waits for the mark, and takes it.
    Player& take(Choice choice) { return wait(options_.quiet).until_marked(choice).press(Choice::B); }
    Player& arrive() { return press(Choice::B).wait(std::chrono::milliseconds(500)); }

    const State& state() const { return state_; }
    const exhibit::State& visit() const { return visit_; }
    exhibit::Screen screen() const { return visit_.screen; }
    std::optional<Choice> marked() const { return state_.marked; }
    Instant now() const { return now_; }
    const Options& options() const { return options_; }
    exhibit::Timings timings() const {
        return patient(usual_, state_.buttons == Buttons::Four ? 1 : options_.patience);
    }
    bool can_go_back() const {
        return visit_.screen == exhibit::Screen::Describe ||
               (visit_.screen == exhibit::Screen::Ask &&
                (visit_.question != genome::Aspect::Trees || !visit_.past_answers.empty()));
    }
    std::vector<exhibit::Wish> wishes;  // all of them
    std::vector<exhibit::Event> told;   // to the visit, all but what it tells itself

    void tick() {
        tell(exhibit::Tick{});
        hear(exhibit::Tick{});
    }
    Player& hear(const Event& event) {
        return take(next(state_, event, {visit_, can_go_back(), Instant{0}, exhibit::meant_by(visit_, timings())}, now_,
                         options_));
    }
    Player& let_go() { return take(switches::let_go(state_)); }
    void pass(Instant time) { now_ += time; }

  private:
    Player& take(Step step) {
        state_ = std::move(step.state);
        for (const exhibit::Event& one : step.events) {
            told.push_back(one);
            tell(one);
        }
        return *this;
    }
    void tell(const exhibit::Event& event) {
        exhibit::Step step = exhibit::next(visit_, event, now_, timings());
        visit_ = std::move(step.state);
        wishes.insert(wishes.end(), step.wishes.begin(), step.wishes.end());
        if (!visit_.is_ready) tell(exhibit::GenerationReady{visit_.generation});
    }

    Options options_;
    exhibit::Timings usual_;
    Instant now_{std::chrono::seconds(1000)};
    exhibit::State visit_;
    State state_;
};

template <typename W>
std::vector<W> all_of(const std::vector<exhibit::Wish>& wishes) {
    std::vector<W> found;
    for (const exhibit::Wish& wish : wishes)
        if (const auto* one = std::get_if<W>(&wish)) found.push_back(*one);
    return found;
}

}  // namespace quadrat::switches
