// SPDX-License-Identifier: Apache-2.0
// The room `exhibit`: the visit as a pure function of state, event and time. No disk (archive), no clock, no thread.
#pragma once
#include <array>
#include <chrono>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "genome/offer.hpp"

namespace quadrat::exhibit {

// The visit as a pure function of state, event and time. It reads no clock, starts no thread and calls nobody: it
// returns the next state and what should happen, and the kiosk does it.

using Instant = std::chrono::nanoseconds;  // since the program started

enum class Choice { A, B, C, D, Back };

// How a visit comes to its landscape: three best-of-four answers a round, or one slider after another turned.
enum class Asking { Picks, Sliders };

// Whether a group is invited to answer a question each.
enum class TakingTurns {
    Never,
    Found,  // when presses tell that there are several: kCrossingsOfAGroup
    Always
};
TakingTurns turns_named(std::string_view name);  // "never", "found", "always"; anything else is "found"

struct Timings {
    std::chrono::milliseconds patience{25'000};       // without a press, until "Still there?"
    std::chrono::milliseconds countdown{10'000};      // of "Still there?", until Attract
    std::chrono::milliseconds finale{20'000};         // the landscape they bred, until Attract
    std::chrono::milliseconds long_press{2'000};      // holding A, B, C or D this long asks for the Finale
    std::chrono::milliseconds press_guard{300};       // after an answer or a new question, a press does not count
    std::chrono::milliseconds finale_guard{1'500};    // the Finale is seen at least this long
    std::chrono::milliseconds growing_limit{60'000};  // a generation that gets on no more ends the visit
    std::chrono::milliseconds describe{15'000};       // of Describe without a press, until Attract
    int rounds = 6;                                   // at least 1; then the Finale
    int describe_words = 3;                           // asked in Describe, one at a time; 0: never
    int describe_every = 2;                           // at least 1: after every so many Finales
    Asking asking = Asking::Picks;
    int sliders = 0;       // how many there are to choose from; at least 1 where they are turned
    int languages = 0;     // that a visitor may choose from as they come; of fewer than two nobody is asked
    int rounds_early = 0;  // the Finale comes so many rounds earlier at most, once picks agree; after two at least
    int rounds_more = 0;   // and so many later at most, as long as they change
    TakingTurns turns = TakingTurns::Never;
    bool finale_asks = false;   // the family tree, going on, printing; otherwise any press leaves the Finale. Not where
                                // sliders are turned
    bool can_print = false;     // a postcard, when it is asked for
    bool prints_all = false;    // without being asked
    bool can_breed_on = false;  // in Attract, button D: from the landscape on show
    bool is_wall = false;       // nobody plays: it stays Attract
};

// Another button within kTogether of one is another hand; after so many in a visit there are several visitors.
inline constexpr std::chrono::milliseconds kTogether{250};
inline constexpr int kCrossingsOfAGroup = 2;
// The family tree of a visit grows no larger: then nobody goes on from the Finale.
inline constexpr std::size_t kMostFamily = 60;

// ---- what happens

struct Pressed {
    Choice button;
};
struct Released {
    Choice button;
};
struct Tick {};
// Somebody is there, though nothing was said to the visit: it is patient anew.
struct Stirred {};
// What a Wish asked for has grown a little further: on a slow machine the visit waits longer.
struct Grew {};
// What a Wish asked for can be shown. Ignored where it is not the generation that the visit waits for.
struct GenerationReady {
    int generation;
};
// What a GrowNext learnt of this visit's picks.
struct Believed {
    bool is_narrow;    // they agree, so that little would come of more
    bool is_changing;  // the last contradict those before them
};
using Event = std::variant<Pressed, Released, Tick, Stirred, Grew, GenerationReady, Believed>;

// ---- where the visit stands

enum class Screen {
    Attract,     // nobody there
    Ask,         // four scenes and one question
    Breed,       // the next four, or the Finale's landscape, are on their way
    StillThere,  // a countdown over the question
    Finale,      // the landscape they bred
    Describe,    // what do you call it? one word at a time, four answers
    Slide,       // one landscape; A and B choose a slider, C and D turn it
    Language,    // which one? before the first question
    Family,      // the visit's family tree, over the Finale's landscape
};

struct Held {
    Choice button;
    Instant since;
    friend bool operator==(const Held&, const Held&) = default;
};

// Four that were offered in a visit, and the answers that led to them from others.
struct Ancestor {
    int parent = -1;  // among the family; -1: the first four
    genome::Pick pick = {};
    bool was_seen = false;  // otherwise the Finale came in their place
    friend bool operator==(const Ancestor&, const Ancestor&) = default;
};

// Passive; made by opening(), resumed() and next() alone.
struct State {
    Screen screen = Screen::Attract;
    Screen after_breed = Screen::Ask;                 // Ask (or Slide, in its place) or Finale: where Breed leads
    genome::Aspect question = genome::Aspect::Trees;  // in Ask and StillThere
    genome::Pick answers;                             // of this round; every aspect before the question, no other
    std::vector<genome::Pick> past_answers;           // of the rounds that Back can still reach, oldest first
    int rounds = 0;                                   // that this visit has completed; a round is three actions
    int slider = 0;                                   // which is chosen, in Slide
    int first_language = 0;                           // that is on button A, in Language
    int turns = 0;                                    // of sliders, in this visit
    int turns_to_undo = 0;                            // that Back can still reach
    int finales = 0;                                  // since the exhibit was switched on
    int described = 0;                                // words answered in Describe
    int generation = 0;                               // the last one that was wished for
    bool is_ready = false;                            // and whether it can be shown
    Instant since{0};                                 // when the screen, or its question, came
    Instant last_press{0};                            // any press, or stirring
    Instant last_growth{0};                           // of what Breed waits for
    std::optional<Held> held;                         // A to D, while it may become a long press
    std::vector<Ancestor> family;                     // of this visit, in the order in which they came; empty: none
    int here = 0;                                     // which of them is on offer, or led to the Finale
    int walked = 0;                                   // which of them Family shows
    bool finale_asks = false;                         // in Finale: the buttons choose
    bool is_printed = false;                          // the Finale's landscape, or will be
    bool breeds_on = false;                           // from what hung in Attract
    std::optional<Held> last_button;                  // pressed in this visit, and when
    int crossings = 0;                                // of hands, in this visit
    friend bool operator==(const State&, const State&) = default;
};

// ---- what should be done about it

enum class Ending {
    Finished,  // after the Finale, and what was asked about it
    Left,      // nobody answered "Still there?"
    Stuck,     // a generation never came
};

// Show in the next frame, and with sound, that the button was pressed. Comes with every press, whatever it meant. It
// changes no lamp: lamps show what can be pressed (kiosk::Switchboard).
struct Acknowledge {
    Choice button;
    friend bool operator==(const Acknowledge&, const Acknowledge&) = default;
};
// Begin with a fresh belief and grow its first four, then say GenerationReady{generation}. Nobody waits for it yet;
// what is on screen may stay there.
struct PrepareVisit {
    int generation;
    friend bool operator==(const PrepareVisit&, const PrepareVisit&) = default;
};
// From now on until the visit ends.
struct SpeakLanguage {
    int which;  // of those to choose from
    friend bool operator==(const SpeakLanguage&, const SpeakLanguage&) = default;
};
// The visit goes on from four that it had, of State::family: that belief and those four; grow them, then say
// GenerationReady.
struct ReturnTo {
    int generation;
    int node;
    friend bool operator==(const ReturnTo&, const ReturnTo&) = default;
};
// Of the landscape on show in Attract: believe that this visitor likes it, grow the four that follow, then say
// GenerationReady.
struct BreedOn {
    int generation;
    friend bool operator==(const BreedOn&, const BreedOn&) = default;
};
// The Finale's landscape on paper.
struct PrintPostcard {
    friend bool operator==(const PrintPostcard&, const PrintPostcard&) = default;
};
// A visitor came: what was prepared is theirs.
struct BeginVisit {
    friend bool operator==(const BeginVisit&, const BeginVisit&) = default;
};
// The answers of this round changed, by a press or by Back. Keep them on disk; an aspect that is judged can begin to
// grow for the next four, one that no longer is can stop.
struct KeepAnswers {
    genome::Pick answers;
    friend bool operator==(const KeepAnswers&, const KeepAnswers&) = default;
};
// Learn from the answers, keep the new belief and the new four on disk, grow them, say Believed, then GenerationReady.
struct GrowNext {
    int generation;
    genome::Pick answers;
    friend bool operator==(const GrowNext&, const GrowNext&) = default;
};
// Take the last round back: the former belief and the former four; grow them unless they are still at hand, then say
// GenerationReady. `answers` of that round stand again.
struct UndoRound {
    int generation;
    genome::Pick answers;
    friend bool operator==(const UndoRound&, const UndoRound&) = default;
};
// Learn from the answers, if any aspect is judged (a round that is not complete is not learnt), then grow the one
// landscape of the aspects last named best, and say GenerationReady.
struct GrowFinale {
    int generation;
    genome::Pick answers;
    friend bool operator==(const GrowFinale&, const GrowFinale&) = default;
};
// The slider was turned a step up (+1) or down (-1): keep that on disk, grow the landscape, then say GenerationReady.
// What is on screen stays until then; another turn may come before.
struct TurnSlider {
    int generation;
    int slider;
    int direction;
    friend bool operator==(const TurnSlider&, const TurnSlider&) = default;
};
// Take the last turn back, keep that, grow the landscape, then say GenerationReady.
struct UndoTurn {
    int generation;
    friend bool operator==(const UndoTurn&, const UndoTurn&) = default;
};
// What the visitor says of the landscape they bred: the answer, 0 to 3, to the which-th word asked. Keep it on disk.
struct KeepWord {
    int which;
    std::size_t answer;
    friend bool operator==(const KeepWord&, const KeepWord&) = default;
};
struct EndVisit {
    Ending ending;
    int rounds;
    friend bool operator==(const EndVisit&, const EndVisit&) = default;
};
using Wish = std::variant<Acknowledge, PrepareVisit, BeginVisit, KeepAnswers, GrowNext, UndoRound, GrowFinale,
                          TurnSlider, UndoTurn, KeepWord, EndVisit, SpeakLanguage, ReturnTo, BreedOn, PrintPostcard>;

struct Step {
    State state;
    std::vector<Wish> wishes;  // in the order in which they should be done
    friend bool operator==(const Step&, const Step&) = default;
};

// The exhibit has just been switched on: Attract, and a visit to prepare.
Step opening(Instant now);

// Switched on again after a plug was pulled in the middle of a visit: Breed until the four of then are ready
// (GenerationReady{state.generation}), then the first question without an answer. `past` are the answers of the rounds
// before, oldest first. `answers` holds those given since: trees, or trees and land; anything else is taken as none.
State resumed(std::vector<genome::Pick> past, const genome::Pick& answers, Instant now);

// The same for a visit in which so many sliders had been turned; Back reaches none of them.
State resumed_sliding(int turns, Instant now);

// One event, at most one change of screen. A time before the last one is taken as no time having passed.
Step next(const State& state, const Event& event, Instant now, const Timings& timings);

// The instant at which a Tick will change something; nothing while only a press or a generation can. A Tick before it
// changes nothing.
std::optional<Instant> next_deadline(const State& state, const Timings& timings);

// ---- what the visitor reads

enum class Prompt {
    PressAnyButton,
    BestTrees,
    BestLand,
    BestSky,
    Growing,
    StillThere,
    YourLandscape,
    WhichWords,
    TurnWords,
    WhichLanguage,
    WhichAncestor
};
Prompt prompt_of(const State& state);

// Whether the four buttons stand for four things to choose from, instead of any press doing.
bool asks(const State& state);

// Whether they are to take turns, a question each.
bool takes_turns(const State& state, const Timings& timings);

// Whether the Finale comes after this round, whatever is answered.
bool is_last_round(const State& state, const Timings& timings);

// In Language, what a button stands for: one of the languages, or the next of them where there are more than four.
// Nothing: neither.
struct LanguageChoice {
    int which = 0;
    bool turns_page = false;
    friend bool operator==(const LanguageChoice&, const LanguageChoice&) = default;
};
std::optional<LanguageChoice> language_on(Choice button, int first_language, int languages);

// Which of A to D stand for something just now; all of them where any press will do.
std::array<bool, 4> meant_by(const State& state, const Timings& timings);

// Seconds left, rounded up, where a countdown is shown: in StillThere, and of what would else go without a word
// (Language, Finale where it asks, Family, Describe) as long as `countdown` before it does. A press there is more time.
std::optional<int> countdown_s(const State& state, Instant now, const Timings& timings);

}  // namespace quadrat::exhibit
