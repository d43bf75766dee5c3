// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "display/display.hpp"

// The screen's life as a pure function: what is known, what has happened, the time; what is known then, and what to do.
// An exhibit's screen is switched off at the wall, exchanged, put to sleep by its own timer and plugged into the other
// socket; none of that ends the program. The ladder when a picture does not come: set the mode again; switch the output
// off and on; close the card and begin anew; and only then Fault, which asks for the process to be restarted.
namespace quadrat::display {

enum class Phase {
    NoCard,       // no usable card yet; looked for every second at first, then every five
    NoConnector,  // a card, and no screen on it; looked for at each plug event and every five seconds
    Modesetting,  // a screen, being set up
    Running,      // frames flow
    Blanked,      // switched off by us; what a sleeping screen does to its plug is ignored
    Lost,         // frames do not reach the screen; about to be set up again
    Fault         // the end
};

// What a card says to a commit, by what can be done about it.
enum class Refusal { None, Busy, NoAccess, Invalid, NoRoom, NoDevice, Other };
Refusal refusal_of(int error_number);  // positive errno; 0: None

struct NothingFound {
    std::string reason;
    bool is_denied = false;  // there is a card, and it is not ours to use
};
struct CardFound {
    std::string reason;  // why it shows nothing
};
struct ScreenFound {
    std::uint32_t connector = 0;
    std::string name;        // "HDMI-A-1, EPS 0x1234 'EPSON PJ'"
    std::uint64_t edid = 0;  // fingerprint
    bool is_link_bad = false;
    int rungs = 1;  // how many ways there are to set it up, best first
};
using ProbeResult = std::variant<NothingFound, CardFound, ScreenFound>;

namespace event {
struct Tick {};
struct PlugMoved {
    bool is_unplugged = false;  // as far as the kernel knows at this moment
};
struct CardAppeared {};
struct CardRemoved {};
struct Probed {
    ProbeResult result;
};
struct ModesetEnded {
    Refusal refusal = Refusal::None;
};
struct FlipStarted {};
struct FlipEnded {};
struct FlipRefused {
    Refusal refusal = Refusal::Other;
};
struct ContextLost {};
struct PowerAsked {
    Power power = Power::On;
};
}  // namespace event
using ScreenEvent = std::variant<event::Tick, event::PlugMoved, event::CardAppeared, event::CardRemoved, event::Probed,
                                 event::ModesetEnded, event::FlipStarted, event::FlipEnded, event::FlipRefused,
                                 event::ContextLost, event::PowerAsked>;

namespace action {
struct Probe {};    // ask the connectors in full; answer with Probed
struct Glance {};   // ask what the kernel knows, without disturbing the cable; answer with PlugMoved when it is news
struct Disable {};  // output off, waiting until it is; forget frames in flight
struct Modeset {    // answer with ModesetEnded
    int rung = 0;
};
struct CloseCard {};  // and everything made on it
struct Say {
    std::string text;
    bool is_warning = false;
};
}  // namespace action
using ScreenAction =
    std::variant<action::Probe, action::Glance, action::Disable, action::Modeset, action::CloseCard, action::Say>;

using Instant = std::chrono::nanoseconds;  // CLOCK_MONOTONIC

struct ScreenState {
    Phase phase = Phase::NoCard;
    std::string reason = "no graphics card was looked for yet";  // empty while running
    Instant since{0};                                            // of this phase
    std::optional<Instant> look_at = Instant{0};                 // when to probe
    std::optional<Instant> glance_at;
    std::optional<Instant> retry_at;      // when to try the same modeset again
    std::optional<Instant> bounce_since;  // the first of a series of plug events
    bool was_unplugged = false;           // in that series
    std::optional<ScreenFound> screen;
    int rung = 0;
    int first_rung = 0;  // better ones have failed by lack of memory or bandwidth
    std::optional<Instant> flip_since;
    bool is_flip_late = false;
    std::optional<Instant> busy_since;
    std::optional<Instant> denied_since;
    int losses = 0;  // since frames last flowed for a minute
};

struct ScreenNext {
    ScreenState state;
    std::vector<ScreenAction> actions;  // in order
};

inline constexpr std::chrono::milliseconds kPlugSettles{1500};        // amplifiers and televisions toggle their plug
inline constexpr std::chrono::milliseconds kPlugSettlesAtLast{6000};  // however long it goes on bouncing
inline constexpr std::chrono::milliseconds kFlipLate{250};
inline constexpr std::chrono::milliseconds kFlipLost{2000};
inline constexpr std::chrono::milliseconds kBusyTooLong{2000};
inline constexpr std::chrono::seconds kDeniedTooLong{10};
inline constexpr std::chrono::seconds kSteadyAgain{60};
inline constexpr std::chrono::seconds kGlanceEvery{10};
inline constexpr int kMostLosses = 6;
inline constexpr int kReopenAfterLosses = 3;

ScreenNext screen_next(const ScreenState& state, const ScreenEvent& event, Instant now);

// What present() reports in this phase.
Outcome outcome_of(Phase phase);
std::string_view name_of(Phase phase);

// A flip's time as reported, made sane: never before the last one, never in the future, never older than the deadline.
Instant sane_flip_time(Instant last, Instant reported, Instant now);

}  // namespace quadrat::display
