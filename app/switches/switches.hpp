// SPDX-License-Identifier: Apache-2.0
// The room `switches`: a visit for who has one button or two. Between buttons and the visit, as a pure function of
// state, event and time: presses in, the visit's own events out. No lamp, no screen, no clock; the visit knows nothing
// of it.
#pragma once
#include <array>
#include <chrono>
#include <optional>
#include <variant>
#include <vector>

#include "exhibit/visit.hpp"

namespace quadrat::switches {

using exhibit::Choice;
using exhibit::Instant;

// With how many buttons somebody plays.
enum class Buttons {
    Four,  // each button is what stands on it
    Two,   // A moves a mark from choice to choice, any other button takes what is marked
    One,   // the mark moves by itself and any button takes what is marked; with a dwell, any button moves it
};

struct Options {
    Buttons always = Buttons::Four;         // so everybody plays here
    Buttons held = Buttons::One;            // so plays who holds a button, until the visit ends
    std::chrono::milliseconds hold{4'000};  // so long; 0: nobody can ask for it
    std::chrono::milliseconds pace{2'000};  // a choice is marked so long before the next one; more than 0
    int times_round = 3;                    // then the mark rests until a press; 0: it goes round for ever
    bool begins_by_itself = true;           // otherwise the mark rests first, too
    std::chrono::milliseconds dwell{0};     // what a press has marked is taken when it stays so long; 0: never
    std::chrono::milliseconds quiet{400};   // after a press that was heard, another is not: for a hand that trembles
    double patience = 3;                    // how many times as long everything waits, while so played; at least 1
};

// The first choice of a question is marked longer, for the question has to be read.
inline constexpr double kFirstPaces = 1.5;

// A button that stays down so long after its wish was granted was nobody's: it is leaned on or stuck, and with its
// release four are played with again.
inline constexpr std::chrono::seconds kNobodysHold{30};

using Event = std::variant<exhibit::Pressed, exhibit::Released, exhibit::Tick>;

struct Hold {
    Choice button;
    Instant since;
    friend bool operator==(const Hold&, const Hold&) = default;
};

// Passive; made by default and by next() alone.
struct State {
    Buttons buttons = Buttons::Four;  // that are played with now
    std::optional<Choice> marked;     // nothing: it rests, or nothing can be chosen
    Instant marked_since{0};
    bool is_marked_by_hand = false;
    int times_round = 0;  // that the mark has been, since it began
    exhibit::Screen screen = exhibit::Screen::Attract;
    Instant asked_since{0};                       // of the question that the mark belongs to
    std::optional<Instant> heard_at;              // the last press that was heard
    std::optional<Hold> hold;                     // while it may become a wish for fewer buttons
    std::optional<Hold> asked_by;                 // whose hold was such a wish and when, until it comes up
    std::array<bool, 5> is_down{};                // by Choice
    std::array<std::optional<Choice>, 5> told{};  // as what a button that is down was told to the visit
    friend bool operator==(const State&, const State&) = default;
};

// What of the visit decides what can be marked.
struct Beside {
    const exhibit::State& visit;
    bool can_go_back = false;
    Instant speaks_until{0};  // what is asked, and the choice that is marked; the mark waits for it
    std::array<bool, 4> meant{true, true, true, true};  // which of A to D stand for something; others are never marked
};

struct Step {
    State state;
    std::vector<exhibit::Event> events;  // for the visit, in this order; Tick is never among them
};

// One event. With four buttons, and where any press will do, each press goes on as it is. A time before the last one is
// taken as no time having passed.
Step next(const State& state, const Event& event, const Beside& beside, Instant now, const Options& options);

// Nothing is held down any more, as far as is known: what was pressed is meant for others.
Step let_go(const State& state);

// The instant at which a Tick will change something; nothing while only a press or the visit can.
std::optional<Instant> next_deadline(const State& state, const Beside& beside, const Options& options);

// Whether the four, and Back, are marked one after another now.
bool is_marking(const State& state, const exhibit::State& visit);

// How far a hold has got toward asking for fewer buttons, 0 to 1.
float hold_share(const State& state, Instant now, const Options& options);

// The times of a visit in which everything waits so many times as long.
exhibit::Timings patient(exhibit::Timings timings, double times);

}  // namespace quadrat::switches
