// SPDX-License-Identifier: Apache-2.0
#include "switches/pace.hpp"

#include <algorithm>

namespace quadrat::switches {
namespace {

using exhibit::Screen;
using std::chrono::milliseconds;

constexpr milliseconds kStep{10};
constexpr std::chrono::hours kLongest{2};

class Play {
  public:
    Play(const std::vector<genome::Pick>& rounds, Buttons buttons, const Options& options, const Hand& hand,
         base::Seed seed)
        : rounds_(rounds), options_(options), hand_(hand), chance_(seed.child("hand")) {
        options_.always = buttons;
        exhibit::Timings usual;
        usual.rounds = static_cast<int>(rounds.size());
        usual.describe_words = 0;
        timings_ = buttons == Buttons::Four ? usual : patient(usual, options.patience);
        take(exhibit::opening(now_));
        take(exhibit::next(visit_, exhibit::GenerationReady{visit_.generation}, now_, timings_));
        tell(exhibit::Pressed{Choice::A});
        tell(exhibit::Released{Choice::A});
        began_ = now_;
        presses_ = 0;
    }

    Pace run() {
        while (now_ < kLongest && visit_.screen != Screen::Attract && visit_.screen != Screen::Finale) {
            now_ += kStep;
            tell(exhibit::Tick{});
            take(exhibit::next(visit_, exhibit::Tick{}, now_, timings_));
            grow();
            if (visit_.screen == Screen::Ask) answer();
            if (visit_.screen == Screen::StillThere) press(Choice::A);
        }
        Pace pace;
        pace.minutes = std::chrono::duration<double, std::ratio<60>>(now_ - began_).count();
        const auto count = static_cast<double>(rounds_.size());
        if (visit_.screen == Screen::Finale) pace.rounds_a_minute = count / pace.minutes;
        pace.presses_a_round = presses_ / count;
        pace.missed = missed_;
        return pace;
    }

  private:
    void take(exhibit::Step step) { visit_ = std::move(step.state); }

    void tell(const Event& event) {
        const Step step = next(state_, event, {visit_, false, {}}, now_, options_);
        state_ = step.state;
        for (const exhibit::Event& one : step.events) take(exhibit::next(visit_, one, now_, timings_));
    }

    Instant about(milliseconds time) {
        const double factor = std::clamp(1 + 0.33 * static_cast<double>(chance_.normal()), 0.3, 2.5);
        return std::chrono::duration_cast<Instant>(factor * std::chrono::duration<double, std::nano>(time));
    }

    void press(Choice button) {
        ++presses_;
        tell(exhibit::Pressed{button});
        now_ += milliseconds{80};
        tell(exhibit::Released{button});
    }

    void grow() {
        if (visit_.screen != Screen::Breed || now_ - visit_.since < hand_.growing) return;
        take(exhibit::next(visit_, exhibit::GenerationReady{visit_.generation}, now_, timings_));
    }

    // What is to be pressed now, if anything is: a decision that takes a reaction's time to carry out.
    std::optional<Choice> wanted() const {
        const auto& pick = rounds_.at(static_cast<std::size_t>(visit_.rounds))[visit_.question];
        const auto aim = static_cast<Choice>(pick.value_or(0));
        if (state_.buttons == Buttons::Four) return aim;
        if (!state_.marked) return Choice::A;  // it rests
        const bool is_there = state_.marked == aim;
        if (state_.buttons == Buttons::Two) return is_there ? Choice::B : Choice::A;
        if (options_.dwell.count() == 0) return is_there ? std::optional(Choice::A) : std::nullopt;
        return is_there && state_.is_marked_by_hand ? std::nullopt : std::optional(Choice::A);
    }

    void answer() {
        if (question_since_ != visit_.since) {
            question_since_ = visit_.since;
            ready_at_ = now_ + about(hand_.thinking);
            due_.reset();
        }
        if (now_ < ready_at_) return;
        const auto press_now = wanted();
        if (!due_ && press_now) due_ = now_ + about(hand_.reaction);
        if (!due_ || now_ < *due_) return;
        due_.reset();
        // By the time the hand moves, the mark may have gone on: who sees that does not press.
        if (!press_now) {
            ++missed_;
            return;
        }
        press(*press_now);
    }

    const std::vector<genome::Pick>& rounds_;
    Options options_;
    Hand hand_;
    base::RandomStream chance_;
    exhibit::Timings timings_;
    exhibit::State visit_;
    State state_;
    Instant now_{0}, began_{0}, ready_at_{0}, question_since_{-1};
    std::optional<Instant> due_;
    double presses_ = 0;
    int missed_ = 0;
};

}  // namespace

Pace pace_of(const std::vector<genome::Pick>& rounds, Buttons buttons, const Options& options, const Hand& hand,
             base::Seed seed) {
    return Play(rounds, buttons, options, hand, seed).run();
}

}  // namespace quadrat::switches
