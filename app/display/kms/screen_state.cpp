// SPDX-License-Identifier: Apache-2.0
#include "display/kms/screen_state.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace quadrat::display {
namespace {

using namespace std::chrono_literals;

constexpr auto kLookOftenFor = 30s;  // after start: udev makes the card's node some seconds into a boot
constexpr auto kLookOften = 1s;
constexpr auto kLookSlowly = 5s;
constexpr auto kRetryBusy = 100ms;
constexpr auto kRetryDenied = 1s;

bool is_due(const std::optional<Instant>& at, Instant now) { return at && *at <= now; }

// One transition: the state being changed, what is to be done, and the verbs that several events share.
class Transition {
  public:
    Transition(const ScreenState& state, Instant now) : next_{state, {}}, now_(now) {}
    ScreenNext take() { return std::move(next_); }

    void operator()(const event::Tick&);
    void operator()(const event::PlugMoved&);
    void operator()(const event::CardAppeared&);
    void operator()(const event::CardRemoved&);
    void operator()(const event::Probed&);
    void operator()(const event::ModesetEnded&);
    void operator()(const event::FlipStarted&);
    void operator()(const event::FlipEnded&);
    void operator()(const event::FlipRefused&);
    void operator()(const event::ContextLost&);
    void operator()(const event::PowerAsked&);

  private:
    ScreenState& s() { return next_.state; }
    void act(ScreenAction action) { next_.actions.push_back(std::move(action)); }
    void say(std::string text) { act(action::Say{std::move(text), false}); }
    void warn(std::string text) { act(action::Say{std::move(text), true}); }
    void enter(Phase phase, std::string reason);
    void forget_frames();
    void lose(const std::string& reason);
    void give_up(const std::string& reason);
    void denied();
    void remove_card(const std::string& reason);
    void set_mode(int rung);
    void refuse_rung();
    void watch_flip();
    void found(const NothingFound& nothing);
    void found(const CardFound& card);
    void found(const ScreenFound& screen);
    bool is_asleep() { return s().phase == Phase::Blanked || s().phase == Phase::Fault; }
    bool is_lit() { return s().phase == Phase::Running || s().phase == Phase::Modesetting || s().phase == Phase::Lost; }

    ScreenNext next_;
    Instant now_;
};

void Transition::enter(Phase phase, std::string reason) {
    if (s().phase != phase) s().since = now_;
    s().phase = phase;
    s().reason = std::move(reason);
    s().retry_at.reset();
    s().glance_at.reset();
}

void Transition::forget_frames() {
    s().flip_since.reset();
    s().is_flip_late = false;
    s().busy_since.reset();
}

void Transition::lose(const std::string& reason) {
    forget_frames();
    act(action::Disable{});
    if (++s().losses > kMostLosses) return give_up(reason);
    warn(fmt::format("screen lost ({} of {}): {}", s().losses, kMostLosses, reason));
    if (s().losses == kReopenAfterLosses) act(action::CloseCard{});
    enter(Phase::Lost, reason);
    s().look_at = s().losses == 1 ? now_ : now_ + std::chrono::seconds{1 << (s().losses - 2)};
}

void Transition::give_up(const std::string& reason) {
    warn("screen: giving up: " + reason);
    enter(Phase::Fault, reason);
    s().look_at.reset();
}

// Not a Disable, which would be denied too: the screen is another program's now. It may let go of it again.
void Transition::denied() {
    if (!s().denied_since) {
        s().denied_since = now_;
        warn("screen: another program has taken it (is a desktop running, or a second exhibit?)");
    }
    forget_frames();
    if (now_ - *s().denied_since >= kDeniedTooLong) return give_up("another program keeps the screen");
    enter(Phase::Lost, "another program has taken the screen");
    s().look_at = now_ + kRetryDenied;
}

void Transition::remove_card(const std::string& reason) {
    forget_frames();
    act(action::CloseCard{});
    warn("screen: " + reason);
    s().screen.reset();
    s().losses = 0;
    enter(Phase::NoCard, reason);
    s().look_at = now_ + kLookOften;
}

void Transition::set_mode(int rung) {
    s().rung = rung;
    act(action::Modeset{rung});
    enter(Phase::Modesetting, "being set up");
}

void Transition::refuse_rung() {
    if (s().rung + 1 >= s().screen->rungs) return lose("the card refuses every mode of the screen");
    warn(fmt::format("screen: the card refuses this mode ({} of {} ways to set it up); trying the next", s().rung + 1,
                     s().screen->rungs));
    set_mode(s().rung + 1);
}

void Transition::watch_flip() {
    if (!s().flip_since) return;
    const auto waited = now_ - *s().flip_since;
    if (waited >= kFlipLost) return lose("a frame was not shown within 2 s");
    if (waited < kFlipLate || s().is_flip_late) return;
    s().is_flip_late = true;
    warn("screen: a frame is later than 250 ms");
}

void Transition::operator()(const event::Tick&) {
    if (is_asleep()) return;
    if (s().phase == Phase::Running) {
        watch_flip();
        if (s().losses > 0 && s().phase == Phase::Running && now_ - s().since >= kSteadyAgain) s().losses = 0;
    }
    if (s().phase == Phase::Modesetting && is_due(s().retry_at, now_)) set_mode(s().rung);
    if (is_due(s().look_at, now_)) {
        s().look_at.reset();
        act(action::Probe{});
    } else if (s().phase == Phase::Running && is_due(s().glance_at, now_)) {
        s().glance_at = now_ + kGlanceEvery;
        act(action::Glance{});
    }
}

void Transition::operator()(const event::PlugMoved& plug) {
    if (is_asleep() || s().phase == Phase::NoCard) return;
    s().was_unplugged = s().was_unplugged || plug.is_unplugged;
    if (!s().bounce_since) s().bounce_since = now_;
    s().look_at = std::min(now_ + kPlugSettles, *s().bounce_since + kPlugSettlesAtLast);
}

void Transition::operator()(const event::CardAppeared&) {
    if (s().phase == Phase::NoCard) s().look_at = now_;
}

void Transition::operator()(const event::CardRemoved&) {
    if (s().phase == Phase::NoCard || s().phase == Phase::Fault) return;
    if (s().phase == Phase::Blanked) return act(action::CloseCard{});  // looked for when it is switched on again
    remove_card("the graphics card was removed");
}

void Transition::operator()(const event::Probed& probed) {
    if (is_asleep()) return;
    s().bounce_since.reset();
    std::visit([this](const auto& result) { found(result); }, probed.result);
}

void Transition::found(const NothingFound& nothing) {
    if (s().phase != Phase::NoCard) return remove_card(nothing.reason);
    if (s().reason != nothing.reason) warn("screen: " + nothing.reason);
    enter(Phase::NoCard, nothing.reason);
    s().look_at = now_ + (now_ - s().since < kLookOftenFor ? kLookOften : kLookSlowly);
}

void Transition::found(const CardFound& card) {
    if (is_lit()) act(action::Disable{});
    if (s().reason != card.reason) say("screen: " + card.reason);
    forget_frames();
    s().was_unplugged = true;  // whatever comes back is set up in full
    s().losses = 0;            // a screen that is away explains what was lost
    enter(Phase::NoConnector, card.reason);
    s().look_at = now_ + kLookSlowly;
}

void Transition::found(const ScreenFound& screen) {
    const bool is_same = s().screen && s().screen->connector == screen.connector && s().screen->edid == screen.edid;
    const bool is_fine = s().phase == Phase::Running && is_same && !screen.is_link_bad && !s().was_unplugged;
    if (is_fine) return;
    if (!is_same) {
        say("screen: " + screen.name);
        if (s().screen && s().screen->edid != screen.edid) warn("screen: it is not the one that was there before");
        s().first_rung = 0;
    }
    if (screen.is_link_bad) warn("screen: the link was lost and is set up again");
    // The full sequence, off and on: a plug that was pulled and put back leaves some links trained for nobody.
    if (is_lit()) act(action::Disable{});
    forget_frames();
    s().was_unplugged = false;
    s().look_at.reset();
    s().screen = screen;
    set_mode(std::min(s().first_rung, screen.rungs - 1));
}

void Transition::operator()(const event::ModesetEnded& ended) {
    if (s().phase != Phase::Modesetting) return;
    if (ended.refusal != Refusal::NoAccess) s().denied_since.reset();
    switch (ended.refusal) {
        case Refusal::None:
            forget_frames();
            enter(Phase::Running, {});
            s().glance_at = now_ + kGlanceEvery;
            return;
        case Refusal::Busy:
            if (!s().busy_since) s().busy_since = now_;
            if (now_ - *s().busy_since >= kBusyTooLong) return lose("the card stays busy");
            s().retry_at = now_ + kRetryBusy;
            return;
        case Refusal::NoAccess:
            return denied();
        case Refusal::Invalid:
        case Refusal::NoRoom:
            return refuse_rung();
        case Refusal::NoDevice:
            return remove_card("the graphics card is gone");
        case Refusal::Other:
            return lose("the card cannot set the mode");
    }
}

void Transition::operator()(const event::FlipStarted&) {
    if (s().phase != Phase::Running) return;
    forget_frames();
    s().flip_since = now_;
}

void Transition::operator()(const event::FlipEnded&) {
    if (s().phase != Phase::Running) return;
    if (s().is_flip_late) say("screen: frames are shown again");
    forget_frames();
}

void Transition::operator()(const event::FlipRefused& refused) {
    if (s().phase != Phase::Running) return;
    switch (refused.refusal) {
        case Refusal::None:
            return;
        case Refusal::Busy:
            if (!s().busy_since) s().busy_since = now_;
            if (now_ - *s().busy_since >= kBusyTooLong) lose("the card stays busy");
            return;
        case Refusal::NoAccess:
            return denied();
        case Refusal::NoDevice:
            return remove_card("the graphics card is gone");
        case Refusal::NoRoom:
            s().first_rung = std::min(s().rung + 1, s().screen->rungs - 1);
            return lose("the card has no room for this size");
        case Refusal::Invalid:
            return lose("the card no longer accepts frames of this mode");
        case Refusal::Other:
            return lose("the card refuses frames");
    }
}

void Transition::operator()(const event::ContextLost&) {
    if (is_asleep() || s().phase == Phase::NoCard) return;
    lose("the GPU lost its context");
    act(action::CloseCard{});
}

void Transition::operator()(const event::PowerAsked& asked) {
    if (s().phase == Phase::Fault) return;
    if (asked.power == Power::Off && s().phase != Phase::Blanked) {
        if (is_lit()) act(action::Disable{});
        forget_frames();
        say("screen: switched off");
        enter(Phase::Blanked, "switched off");
        s().look_at.reset();
        s().bounce_since.reset();
    } else if (asked.power == Power::On && s().phase == Phase::Blanked) {
        say("screen: switched on");
        s().was_unplugged = true;
        enter(Phase::NoConnector, "being switched on");
        s().look_at = now_;
    }
}

}  // namespace

Refusal refusal_of(int error_number) {
    switch (error_number) {
        case 0:
            return Refusal::None;
        case EBUSY:
        case EAGAIN:
        case EINTR:
            return Refusal::Busy;
        case EACCES:
        case EPERM:
            return Refusal::NoAccess;
        case EINVAL:
        case ENOENT:
            return Refusal::Invalid;  // ENOENT: a connector or a mode that is no more
        case ENOSPC:
        case ERANGE:
        case ENOMEM:
            return Refusal::NoRoom;
        case ENODEV:
        case ENXIO:
        case EBADF:
            return Refusal::NoDevice;
        default:
            return Refusal::Other;
    }
}

ScreenNext screen_next(const ScreenState& state, const ScreenEvent& event, Instant now) {
    Transition transition{state, now};
    std::visit(transition, event);
    return transition.take();
}

Outcome outcome_of(Phase phase) {
    switch (phase) {
        case Phase::NoCard:
        case Phase::NoConnector:
            return Outcome::NoScreen;
        case Phase::Running:
            return Outcome::Shown;
        case Phase::Blanked:
            return Outcome::Off;
        case Phase::Modesetting:
        case Phase::Lost:
            return Outcome::Lost;
        case Phase::Fault:
            break;
    }
    return Outcome::Fault;
}

std::string_view name_of(Phase phase) {
    switch (phase) {
        case Phase::NoCard:
            return "no card";
        case Phase::NoConnector:
            return "no screen";
        case Phase::Modesetting:
            return "being set up";
        case Phase::Running:
            return "running";
        case Phase::Blanked:
            return "switched off";
        case Phase::Lost:
            return "lost";
        case Phase::Fault:
            break;
    }
    return "fault";
}

Instant sane_flip_time(Instant last, Instant reported, Instant now) {
    const bool is_sane = reported > last && reported <= now && now - reported < kFlipLost;
    return is_sane ? reported : std::max(now, last + Instant{1});
}

}  // namespace quadrat::display
