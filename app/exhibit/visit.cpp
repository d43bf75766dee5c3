// SPDX-License-Identifier: Apache-2.0
#include "exhibit/visit.hpp"

#include <algorithm>
#include <utility>

#include "exhibit/turn.hpp"

namespace quadrat::exhibit {
namespace {

using genome::Aspect;
using genome::kAspects;

constexpr int kLeastRounds = 2;  // before a Finale that comes early

void prepare_visit(Turn& turn) { turn.wishes.emplace_back(PrepareVisit{new_generation(turn.state)}); }

// What is asked, or turned, between landscapes.
Screen question_screen(const Timings& timings) {
    return timings.asking == Asking::Sliders ? Screen::Slide : Screen::Ask;
}

void ask(Turn& turn, Aspect question) {
    State& state = turn.state;
    state.question = question;
    if (!state.family.empty()) state.family[static_cast<std::size_t>(state.here)].was_seen = true;
    show(turn, question_screen(turn.timings));
}

// The first question without an answer. A complete round has none, so the last question: its answer was taken back.
Aspect open_question(const genome::Pick& answers) {
    const auto open = std::ranges::find_if(kAspects, [&](Aspect aspect) { return !answers[aspect]; });
    return open == kAspects.end() ? kAspects.back() : *open;
}

void forget_visit(State& state) {
    state.answers = {};
    state.past_answers.clear();
    state.rounds = 0;
    state.slider = 0;
    state.first_language = 0;
    state.turns = 0;
    state.turns_to_undo = 0;
    state.described = 0;
    state.question = Aspect::Trees;
    state.after_breed = Screen::Ask;
    state.held.reset();
    state.family.clear();
    state.here = 0;
    state.walked = 0;
    state.finale_asks = false;
    state.is_printed = false;
    state.breeds_on = false;
    state.last_button.reset();
    state.crossings = 0;
}

void begin_visit(Turn& turn) {
    const bool breeds_on = turn.state.breeds_on;
    forget_visit(turn.state);
    if (turn.timings.asking == Asking::Picks) turn.state.family.emplace_back();
    turn.wishes.emplace_back(BeginVisit{});
    turn.state.breeds_on = breeds_on;
    if (breeds_on) {
        turn.wishes.emplace_back(BreedOn{new_generation(turn.state)});
        breed(turn, Screen::Ask);
    } else if (turn.state.is_ready) {
        ask(turn, Aspect::Trees);
    } else {
        breed(turn, Screen::Ask);
    }
}

void arrive(Turn& turn, Choice button) {
    if (turn.timings.is_wall) return;
    turn.state.breeds_on = turn.timings.can_breed_on && turn.timings.asking == Asking::Picks && button == Choice::D;
    if (turn.timings.languages < 2) return begin_visit(turn);
    turn.state.first_language = 0;
    show(turn, Screen::Language);
}

void press_in_language(Turn& turn, Choice button) {
    if (turn.now - turn.state.since < turn.timings.press_guard) return;
    if (button == Choice::Back) return show(turn, Screen::Attract);
    const auto choice = language_on(button, turn.state.first_language, turn.timings.languages);
    if (!choice) return;
    if (choice->turns_page) {
        turn.state.first_language = choice->which;
        return show(turn, Screen::Language);
    }
    turn.wishes.emplace_back(SpeakLanguage{choice->which});
    begin_visit(turn);
}

void end_round(Turn& turn) {
    State& state = turn.state;
    const bool is_last = is_last_round(state, turn.timings);
    const genome::Pick answers = std::exchange(state.answers, {});
    state.past_answers.push_back(answers);
    state.question = Aspect::Trees;
    ++state.rounds;
    state.family.push_back({state.here, answers});
    state.here = static_cast<int>(state.family.size()) - 1;
    if (is_last) {
        grow_finale(turn, answers);
        return;
    }
    turn.wishes.emplace_back(GrowNext{new_generation(state), answers});
    breed(turn, Screen::Ask);
}

void answer(Turn& turn, Choice choice) {
    State& state = turn.state;
    state.answers[state.question] = static_cast<std::size_t>(choice);
    if (state.question == kAspects.back()) {
        end_round(turn);
        return;
    }
    turn.wishes.emplace_back(KeepAnswers{state.answers});
    ask(turn, open_question(state.answers));
}

// Back is always one answer back, also across the beginning of a round.
void take_back(Turn& turn) {
    State& state = turn.state;
    if (state.question != kAspects.front()) {
        const auto last = kAspects[static_cast<std::size_t>(state.question) - 1];
        state.answers[last].reset();
        turn.wishes.emplace_back(KeepAnswers{state.answers});
        ask(turn, last);
    } else if (!state.past_answers.empty()) {
        state.answers = state.past_answers.back();
        state.past_answers.pop_back();
        state.answers[kAspects.back()].reset();
        --state.rounds;
        state.here = state.family[static_cast<std::size_t>(state.here)].parent;
        turn.wishes.emplace_back(UndoRound{new_generation(state), state.answers});
        breed(turn, Screen::Ask);
    }
}

void press_in_ask(Turn& turn, Choice button) {
    // A bounce of the hand, or a press meant for what stood here a moment ago.
    if (turn.now - turn.state.since < turn.timings.press_guard) return;
    if (button == Choice::Back) {
        take_back(turn);
    } else {
        answer(turn, button);
    }
}

bool listens_to_holding(const State& state) {
    return state.screen == Screen::Ask || state.screen == Screen::Slide ||
           (state.screen == Screen::Breed && state.after_breed == Screen::Ask);
}

// Two buttons at once are of two hands, and mostly of two visitors who are not of one mind.
void note_hand(Turn& turn, Choice button) {
    State& state = turn.state;
    const auto& last = state.last_button;
    const bool is_judging = state.screen == Screen::Ask || state.screen == Screen::Breed;
    if (is_judging && last && last->button != button && turn.now - last->since < kTogether) ++state.crossings;
    state.last_button = Held{button, turn.now};
}

void press(Turn& turn, Choice button) {
    State& state = turn.state;
    turn.wishes.emplace_back(Acknowledge{button});
    if (state.screen != Screen::Attract) note_hand(turn, button);
    state.last_press = turn.now;
    if (button != Choice::Back && listens_to_holding(state)) state.held = Held{button, turn.now};
    switch (state.screen) {
        case Screen::Attract:
            return arrive(turn, button);
        case Screen::Ask:
            return press_in_ask(turn, button);
        case Screen::Breed:
            return;
        case Screen::StillThere:
            return show(turn, question_screen(turn.timings));
        case Screen::Finale:
            return press_in_finale(turn, button);
        case Screen::Describe:
            return press_in_describe(turn, button);
        case Screen::Slide:
            return press_in_slide(turn, button);
        case Screen::Language:
            return press_in_language(turn, button);
        case Screen::Family:
            return press_in_family(turn, button);
    }
}

void release(Turn& turn, Choice button) {
    if (turn.state.held && turn.state.held->button == button) turn.state.held.reset();
}

void generation_ready(Turn& turn, int generation) {
    State& state = turn.state;
    if (generation != state.generation || state.is_ready) return;
    state.is_ready = true;
    if (state.screen != Screen::Breed) return;
    if (state.after_breed == Screen::Ask) {
        ask(turn, open_question(state.answers));
        return;
    }
    ++state.finales;
    show_finale(turn);
    prepare_visit(turn);
}

// Whether what was learnt is enough: then the Finale comes in place of the next four.
void believe(Turn& turn, const Believed& belief) {
    const State& state = turn.state;
    const Timings& timings = turn.timings;
    const bool is_between = state.screen == Screen::Breed && state.after_breed == Screen::Ask && !state.is_ready;
    if (!is_between || state.family.empty() || state.answers != genome::Pick{}) return;
    const int least = std::max(kLeastRounds, timings.rounds - timings.rounds_early);
    const bool is_early = timings.rounds_early > 0 && belief.is_narrow && state.rounds >= least;
    const bool is_time = state.rounds >= timings.rounds && !belief.is_changing;
    if (is_early || is_time) grow_finale(turn, {});
}

std::optional<Instant> screen_deadline(const State& state, const Timings& timings) {
    switch (state.screen) {
        case Screen::Attract:
            return std::nullopt;
        case Screen::Ask:
        case Screen::Slide:
        case Screen::Language:
            return std::max(state.since, state.last_press) + timings.patience;
        case Screen::Breed:
            return std::max(state.since, state.last_growth) + timings.growing_limit;
        case Screen::StillThere:
            return state.since + timings.countdown;
        case Screen::Finale:
            return (state.finale_asks ? std::max(state.since, state.last_press) : state.since) + timings.finale;
        case Screen::Family:
            return std::max(state.since, state.last_press) + timings.patience;
        case Screen::Describe:
            return std::max(state.since, state.last_press) + timings.describe;
    }
    return std::nullopt;
}

// A press held long asks for the Finale once there is something to show.
std::optional<Instant> hold_deadline(const State& state, const Timings& timings) {
    if (!state.held || (state.rounds == 0 && state.turns == 0) || !listens_to_holding(state)) return std::nullopt;
    return state.held->since + timings.long_press;
}

void screen_times_out(Turn& turn) {
    switch (turn.state.screen) {
        case Screen::Attract:
            return;
        case Screen::Ask:
        case Screen::Slide:
            return show(turn, Screen::StillThere);
        case Screen::Breed:
            return end_visit(turn, Ending::Stuck, NextVisit::ToPrepare);
        case Screen::StillThere:
            return end_visit(turn, Ending::Left, NextVisit::ToPrepare);
        case Screen::Finale:
        case Screen::Family:
            return leave_finale(turn);
        case Screen::Describe:
            return end_visit(turn, Ending::Finished, NextVisit::Prepared);
        case Screen::Language:
            return show(turn, Screen::Attract);  // no visit has begun
    }
}

void tick(Turn& turn) {
    const auto is_due = [&](std::optional<Instant> deadline) { return deadline && turn.now >= *deadline; };
    if (is_due(hold_deadline(turn.state, turn.timings))) {
        turn.state.answers = {};
        turn.state.question = Aspect::Trees;
        grow_finale(turn, {});
    } else if (is_due(screen_deadline(turn.state, turn.timings))) {
        turn.state.held.reset();
        screen_times_out(turn);
    }
}

struct Handle {
    Turn& turn;
    void operator()(const Pressed& event) const { press(turn, event.button); }
    void operator()(const Released& event) const { release(turn, event.button); }
    void operator()(const Tick&) const { tick(turn); }
    void operator()(const Stirred&) const { turn.state.last_press = turn.now; }
    void operator()(const Grew&) const { turn.state.last_growth = turn.now; }
    void operator()(const GenerationReady& event) const { generation_ready(turn, event.generation); }
    void operator()(const Believed& event) const { believe(turn, event); }
};

}  // namespace

void show(Turn& turn, Screen screen) {
    turn.state.screen = screen;
    turn.state.since = turn.now;
}

int new_generation(State& state) {
    state.is_ready = false;
    return ++state.generation;
}

void breed(Turn& turn, Screen after) {
    turn.state.after_breed = after;
    show(turn, Screen::Breed);
}

void grow_finale(Turn& turn, const genome::Pick& answers) {
    turn.wishes.emplace_back(GrowFinale{new_generation(turn.state), answers});
    turn.state.held.reset();
    breed(turn, Screen::Finale);
}

void end_visit(Turn& turn, Ending ending, NextVisit next_visit) {
    turn.wishes.emplace_back(EndVisit{ending, turn.state.rounds});
    forget_visit(turn.state);
    show(turn, Screen::Attract);
    if (next_visit == NextVisit::ToPrepare) prepare_visit(turn);
}

Step opening(Instant now) {
    State state;
    state.since = now;
    state.last_press = now;
    const int generation = new_generation(state);
    return {state, {PrepareVisit{generation}}};
}

State resumed(std::vector<genome::Pick> past, const genome::Pick& answers, Instant now) {
    State state;
    state.screen = Screen::Breed;
    state.rounds = static_cast<int>(past.size());
    state.family.push_back({-1, {}, true});
    for (const genome::Pick& pick : past)
        state.family.push_back({static_cast<int>(state.family.size()) - 1, pick, true});
    state.here = state.rounds;
    state.past_answers = std::move(past);
    state.since = now;
    state.last_press = now;
    new_generation(state);
    if (answers[Aspect::Trees]) {
        state.answers[Aspect::Trees] = answers[Aspect::Trees];
        if (!answers[Aspect::Sky]) state.answers[Aspect::Land] = answers[Aspect::Land];
    }
    return state;
}

State resumed_sliding(int turns, Instant now) {
    State state = resumed({}, {}, now);
    state.family.clear();
    state.rounds = std::max(0, turns) / kTurnsARound;
    state.turns = std::max(0, turns);
    return state;
}

Step next(const State& state, const Event& event, Instant now, const Timings& timings) {
    const Instant latest = std::max({now, state.since, state.last_press, state.last_growth});
    Turn turn{state, {}, latest, timings};
    std::visit(Handle{turn}, event);
    return {std::move(turn.state), std::move(turn.wishes)};
}

std::optional<Instant> next_deadline(const State& state, const Timings& timings) {
    const auto screen = screen_deadline(state, timings);
    const auto hold = hold_deadline(state, timings);
    if (!screen || !hold) return screen ? screen : hold;
    return std::min(*screen, *hold);
}

}  // namespace quadrat::exhibit
