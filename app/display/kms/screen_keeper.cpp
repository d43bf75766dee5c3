// SPDX-License-Identifier: Apache-2.0
#include "display/kms/screen_keeper.hpp"

#include <algorithm>
#include <utility>

#include "base/log.hpp"

namespace quadrat::display {
namespace {

using namespace std::chrono_literals;

constexpr Instant kUnseenFrame = 100ms;
constexpr Instant kLookAtTheClock = 50ms;  // how long a wait for a flip may go without checking its deadlines
constexpr Instant kBusyPause = 5ms;

template <typename... Visitors>
struct Overloaded : Visitors... {
    using Visitors::operator()...;
};
template <typename... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

}  // namespace

void ScreenKeeper::attend() {
    take_news(0ns);
    feed(event::Tick{});
}

Presented ScreenKeeper::present(const tempo::HandOver& how) {
    ++frame_;
    attend();
    if (state_.phase == Phase::Running) {
        show_frame(how);
    } else {
        flights_.interrupted();
        take_news(kUnseenFrame);
    }
    return told();
}

// Actions answer with events, so events queue: each is seen by the state that the one before it left.
void ScreenKeeper::feed(ScreenEvent event) {
    queue_.push_back(std::move(event));
    if (is_feeding_) return;
    is_feeding_ = true;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
        const ScreenEvent next_event = queue_[i];
        ScreenNext next = screen_next(state_, next_event, hardware_.now());
        state_ = std::move(next.state);
        for (const ScreenAction& action : next.actions) perform(action);
    }
    queue_.clear();
    is_feeding_ = false;
}

void ScreenKeeper::perform(const ScreenAction& wanted) {
    std::visit(
        Overloaded{
            [this](const action::Probe&) { feed(event::Probed{hardware_.probe()}); },
            [this](const action::Glance&) {
                if (const auto moved = hardware_.glance()) feed(*moved);
            },
            [this](const action::Disable&) { hardware_.disable(); },
            [this](const action::Modeset& modeset) { feed(event::ModesetEnded{hardware_.modeset(modeset.rung)}); },
            [this](const action::CloseCard&) { hardware_.close_card(); },
            [](const action::Say& say) {
                base::log::write(say.is_warning ? base::log::Level::Warning : base::log::Level::Info, say.text);
            }},
        wanted);
}

void ScreenKeeper::take_news(Instant at_most) {
    for (const News& news : hardware_.wait(at_most))
        std::visit(Overloaded{[this](const FlipShown& shown) {
                                  if (!state_.flip_since) return;  // of a screen that was lost meanwhile
                                  shown_at_ = sane_flip_time(shown_at_, shown.at, hardware_.now());
                                  shown_frame_ = handed_over_;
                                  flights_.shown(base::DisplayTime{shown_at_}, hardware_.period());
                                  feed(event::FlipEnded{});
                              },
                              [this](const auto& moved) { feed(moved); }},
                   news);
}

void ScreenKeeper::wait_for_flip() {
    while (state_.phase == Phase::Running && state_.flip_since) {
        take_news(kLookAtTheClock);
        if (state_.flip_since) feed(event::Tick{});
    }
}

// What happens meanwhile is taken.
void ScreenKeeper::wait_until(base::DisplayTime at) {
    while (state_.phase == Phase::Running && hardware_.now() < at.time_since_epoch())
        take_news(std::min(at.time_since_epoch() - hardware_.now(), kLookAtTheClock));
}

void ScreenKeeper::show_frame(const tempo::HandOver& how) {
    wait_for_flip();
    if (how.not_before) wait_until(*how.not_before);
    while (state_.phase == Phase::Running) {
        const std::optional<Refusal> refusal = hardware_.flip();
        if (!refusal) return feed(event::ContextLost{});
        if (*refusal == Refusal::None) {
            handed_over_ = frame_;
            flights_.handed_over(frame_, how, base::DisplayTime{hardware_.now()});
            feed(event::FlipStarted{});
            if (how.then == tempo::HandOver::Then::Wait) wait_for_flip();
            return;
        }
        feed(event::FlipRefused{*refusal});
        if (state_.phase == Phase::Running) take_news(kBusyPause);
    }
}

Presented ScreenKeeper::told() {
    return {outcome_of(state_.phase),
            shown_frame_,
            base::DisplayTime{shown_at_},
            state_.phase == Phase::Running ? hardware_.period() : Instant{0},
            state_.reason,
            flights_.take_finished(),
            flights_.in_flight_since()};
}

}  // namespace quadrat::display
