// SPDX-License-Identifier: Apache-2.0
#include "kiosk/switchboard.hpp"

#include <cmath>
#include <utility>

#include "base/log.hpp"
#include "kiosk/signals.hpp"

namespace quadrat::kiosk {
namespace {

using firmware_io::LampPattern;
using switches::Buttons;

// A short press is no wish for fewer buttons, and nothing is shown of it.
constexpr float kHoldSeen = 0.25F;

Buttons buttons_named(const std::string& name) {
    return name == "one" ? Buttons::One : name == "two" ? Buttons::Two : Buttons::Four;
}

std::chrono::milliseconds milliseconds_of(double seconds) {
    return std::chrono::milliseconds(std::llround(seconds * 1000.0));
}

}  // namespace

switches::Options switch_options_of(const site::Configuration& configuration) {
    const site::Configuration::Play& play = configuration.play;
    switches::Options options;
    options.always = buttons_named(play.buttons);
    options.held = buttons_named(play.held);
    options.hold = milliseconds_of(play.hold_s);
    options.pace = milliseconds_of(play.pace_s);
    options.times_round = play.times_round;
    options.begins_by_itself = play.begins_by_itself;
    options.dwell = milliseconds_of(play.dwell_s);
    options.quiet = milliseconds_of(play.quiet_s);
    options.patience = play.patience;
    return options;
}

void Switchboard::take(const switches::Step& step, base::Instant now) {
    const Buttons before = std::exchange(state_, step.state).buttons;
    if (before != state_.buttons) {
        constexpr const char* kNames[] = {"four buttons", "two buttons", "one button"};
        base::log::info("played with {}", kNames[static_cast<std::size_t>(state_.buttons)]);
        show_.wait_longer(state_.buttons == Buttons::Four ? 1 : configuration_.play.patience);
    }
    for (const exhibit::Event& event : step.events) show_.happen(event, now);
}

void Switchboard::take_edge(const firmware_io::ButtonEdge& edge, base::Instant now) {
    const exhibit::Choice button = choice_of(edge.button);
    const switches::Event event = edge.motion == firmware_io::Motion::Down ? switches::Event(exhibit::Pressed{button})
                                                                           : exhibit::Released{button};
    take(switches::next(state_, event, beside(), now, switch_options_of(configuration_)), now);
}

void Switchboard::let_go(base::Instant now) { take(switches::let_go(state_), now); }

void Switchboard::look(base::Instant now) {
    take(switches::next(state_, exhibit::Tick{}, beside(), now, switch_options_of(configuration_)), now);
}

std::optional<base::Instant> Switchboard::next_deadline() const {
    return switches::next_deadline(state_, beside(), switch_options_of(configuration_));
}

hearing::Subject Switchboard::heard(base::Instant now) const {
    hearing::Subject subject = show_.heard(now);
    subject.is_marking = switches::is_marking(state_, show_.state());
    if (const auto shown = scanned(now)) subject.hint = shown->hint;
    if (subject.is_marking && state_.screen == show_.state().screen) subject.marked = state_.marked;
    return subject;
}

firmware_io::Lamps Switchboard::lamps() const {
    firmware_io::Lamps lamps = lamps_for(show_);
    if (!switches::is_marking(state_, show_.state())) return lamps;
    lamps.fill(state_.marked ? LampPattern::Off : LampPattern::Breathing);
    if (state_.marked) lamps[static_cast<std::size_t>(*state_.marked)] = LampPattern::Steady;
    return lamps;
}

std::string Switchboard::hint(const switches::Options& options) const {
    if (!state_.marked) return "scan.rest";
    if (state_.buttons == Buttons::Two) return "scan.two";
    return options.dwell.count() > 0 ? "scan.step" : "scan.one";
}

std::optional<stage::Scanned> Switchboard::scanned(base::Instant now) const {
    const switches::Options options = switch_options_of(configuration_);
    stage::Scanned shown;
    if (const float share = switches::hold_share(state_, now, options); share >= kHoldSeen) {
        shown.hold = (share - kHoldSeen) / (1 - kHoldSeen);
        shown.hint = options.held == Buttons::Two ? "hold.two" : "hold.one";
        return shown;
    }
    const bool can_ask = options.always == Buttons::Four && options.hold.count() > 0;
    if (show_.state().screen == exhibit::Screen::Attract && can_ask) {
        shown.hint = options.held == Buttons::Two ? "invite.two" : "invite.one";
        return shown;
    }
    if (!switches::is_marking(state_, show_.state()) || state_.screen != show_.state().screen) return std::nullopt;
    shown.marked = state_.marked;
    shown.hint = hint(options);
    shown.offers_back = show_.can_go_back();
    return shown;
}

}  // namespace quadrat::kiosk
