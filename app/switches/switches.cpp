// SPDX-License-Identifier: Apache-2.0
// Automatic, step and dwell scanning, as switch users know them (ISO 9241-171; Angelo 1992, "Comparison of three
// computer scanning modes"). The mark never moves while a button is down: who presses slowly still takes what they saw.
#include "switches/switches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrat::switches {
namespace {

using exhibit::Screen;

struct Turn {
    State state;
    std::vector<exhibit::Event> events;
    const Beside& beside;
    Instant now;
    const Options& options;
};

std::size_t index_of(Choice choice) { return static_cast<std::size_t>(choice); }

bool is_any_down(const State& state) {
    return std::ranges::any_of(state.is_down, [](bool is_down) { return is_down; });
}

// A press moves the mark; otherwise it moves by itself.
bool is_stepped(const State& state, const Options& options) {
    return state.buttons == Buttons::Two || options.dwell.count() > 0;
}

// Holding a button has no other meaning there.
bool is_holding_free(const exhibit::State& visit) {
    switch (visit.screen) {
        case Screen::Attract:
        case Screen::StillThere:
        case Screen::Language:
            return true;
        case Screen::Ask:
        case Screen::Slide:
            return visit.rounds == 0 && visit.turns == 0;
        default:
            return false;
    }
}

std::optional<Instant> hold_deadline(const State& state, const Options& options) {
    if (!state.hold || options.hold.count() <= 0) return std::nullopt;
    return state.hold->since + options.hold;
}

// Of A to D and Back, whether it can be chosen now.
bool is_meant(const Beside& beside, std::size_t index) {
    return index < beside.meant.size() ? beside.meant[index] : beside.can_go_back;
}

std::optional<Choice> first_meant(const Beside& beside) {
    for (std::size_t i = 0; i <= index_of(Choice::Back); ++i)
        if (is_meant(beside, i)) return static_cast<Choice>(i);
    return std::nullopt;
}

Instant marked_for(const State& state, const Beside& beside, const Options& options) {
    const bool is_first = state.marked == first_meant(beside) && state.times_round == 0;
    return is_first ? std::chrono::milliseconds(std::llround(kFirstPaces * static_cast<double>(options.pace.count())))
                    : options.pace;
}

std::optional<Instant> mark_deadline(const State& state, const Beside& beside, const Options& options) {
    if (!is_marking(state, beside.visit) || !state.marked || is_any_down(state)) return std::nullopt;
    const Instant since = std::max(state.marked_since, beside.speaks_until);
    if (!is_stepped(state, options)) return since + marked_for(state, beside, options);
    if (options.dwell.count() > 0 && state.is_marked_by_hand) return since + options.dwell;
    return std::nullopt;
}

void mark(Turn& turn, std::optional<Choice> choice) {
    turn.state.marked = choice;
    turn.state.marked_since = turn.now;
    turn.state.is_marked_by_hand = false;
}

void begin_marking(Turn& turn) {
    turn.state.times_round = 0;
    mark(turn, first_meant(turn.beside));
}

void move_on(Turn& turn) {
    for (std::size_t next = index_of(*turn.state.marked) + 1; next <= index_of(Choice::Back); ++next)
        if (is_meant(turn.beside, next)) return mark(turn, static_cast<Choice>(next));
    ++turn.state.times_round;
    mark(turn, first_meant(turn.beside));
}

// The visit asks something else now, or nothing; or the site has changed how it is played.
void follow_visit(Turn& turn) {
    State& state = turn.state;
    const exhibit::State& visit = turn.beside.visit;
    const Buttons before = state.buttons;
    const bool has_ended = visit.screen == Screen::Attract && state.screen != Screen::Attract;
    if (has_ended || turn.options.always != Buttons::Four) state.buttons = turn.options.always;
    if (has_ended) state.hold = state.asked_by = std::nullopt;
    if (state.screen == visit.screen && state.asked_since == visit.since && state.buttons == before) return;
    state.screen = visit.screen;
    state.asked_since = visit.since;
    mark(turn, std::nullopt);
    state.times_round = 0;
    // What nobody has marked is never taken by a dwell, and who marks with it begins by a press.
    const bool begins = turn.options.begins_by_itself && turn.options.dwell.count() == 0;
    if (is_marking(state, visit) && begins) begin_marking(turn);
}

void tell(Turn& turn, Choice button, Choice as) {
    turn.events.emplace_back(exhibit::Pressed{as});
    turn.state.told[index_of(button)] = as;
}

// A press by somebody who has not four buttons.
void press_to_choose(Turn& turn, Choice button) {
    State& state = turn.state;
    if (state.heard_at && turn.now - *state.heard_at < turn.options.quiet) return;
    state.heard_at = turn.now;
    if (!is_marking(state, turn.beside.visit)) return tell(turn, button, button);
    const bool moves = is_stepped(state, turn.options) && (state.buttons == Buttons::One || button == Choice::A);
    if (state.marked && !moves) {
        tell(turn, button, *state.marked);
        state.marked_since = turn.now;
        state.is_marked_by_hand = false;
        return;
    }
    if (state.marked)
        move_on(turn);
    else
        begin_marking(turn);
    state.is_marked_by_hand = moves;
    turn.events.emplace_back(exhibit::Stirred{});
}

void press(Turn& turn, Choice button) {
    State& state = turn.state;
    const bool is_alone = !is_any_down(state);
    state.is_down[index_of(button)] = true;
    const bool may_ask = turn.options.hold.count() > 0 && turn.options.held != Buttons::Four &&
                         state.buttons == Buttons::Four && is_holding_free(turn.beside.visit);
    state.hold = is_alone && may_ask ? std::optional(Hold{button, turn.now}) : std::nullopt;
    if (state.buttons == Buttons::Four) return tell(turn, button, button);
    press_to_choose(turn, button);
}

void release(Turn& turn, Choice button) {
    State& state = turn.state;
    state.is_down[index_of(button)] = false;
    if (state.hold && state.hold->button == button) state.hold.reset();
    if (const auto told = std::exchange(state.told[index_of(button)], std::nullopt))
        turn.events.emplace_back(exhibit::Released{*told});
    const bool is_wish = state.asked_by && state.asked_by->button == button;
    if (is_wish && turn.now - std::exchange(state.asked_by, std::nullopt)->since >= kNobodysHold) {
        state.buttons = turn.options.always;
        state.asked_since = Instant::min();
        follow_visit(turn);
    }
    // What was marked meanwhile is marked for its whole time.
    if (!is_any_down(state) && state.marked) state.marked_since = turn.now;
}

void play_with_fewer(Turn& turn) {
    State& state = turn.state;
    state.buttons = turn.options.held;
    const Choice button = std::exchange(state.hold, std::nullopt)->button;
    state.asked_by = Hold{button, turn.now};
    if (const auto told = std::exchange(state.told[index_of(button)], std::nullopt))
        turn.events.emplace_back(exhibit::Released{*told});
    turn.events.emplace_back(exhibit::Stirred{});
    state.asked_since = Instant::min();
    follow_visit(turn);
}

void tick(Turn& turn) {
    State& state = turn.state;
    if (const auto due = hold_deadline(state, turn.options); due && turn.now >= *due) return play_with_fewer(turn);
    const auto due = mark_deadline(state, turn.beside, turn.options);
    if (!due || turn.now < *due) return;
    if (is_stepped(state, turn.options)) {
        turn.events = {exhibit::Pressed{*state.marked}, exhibit::Released{*state.marked}};
        state.marked_since = turn.now;
        state.is_marked_by_hand = false;
        return;
    }
    move_on(turn);
    if (turn.options.times_round > 0 && state.times_round >= turn.options.times_round) mark(turn, std::nullopt);
}

struct Handle {
    Turn& turn;
    void operator()(const exhibit::Pressed& event) const { press(turn, event.button); }
    void operator()(const exhibit::Released& event) const { release(turn, event.button); }
    void operator()(const exhibit::Tick&) const { tick(turn); }
};

}  // namespace

Step next(const State& state, const Event& event, const Beside& beside, Instant now, const Options& options) {
    Turn turn{state, {}, beside, std::max(now, state.marked_since), options};
    follow_visit(turn);
    std::visit(Handle{turn}, event);
    return {turn.state, std::move(turn.events)};
}

Step let_go(const State& state) {
    Step step{state, {}};
    for (auto& told : step.state.told)
        if (told) step.events.emplace_back(exhibit::Released{*std::exchange(told, std::nullopt)});
    step.state.is_down = {};
    step.state.hold = step.state.asked_by = std::nullopt;
    return step;
}

std::optional<Instant> next_deadline(const State& state, const Beside& beside, const Options& options) {
    const bool is_behind = state.screen != beside.visit.screen || state.asked_since != beside.visit.since;
    if (is_behind) return beside.visit.since;
    const auto hold = hold_deadline(state, options);
    const auto marked = mark_deadline(state, beside, options);
    if (!hold || !marked) return hold ? hold : marked;
    return std::min(*hold, *marked);
}

bool is_marking(const State& state, const exhibit::State& visit) {
    return state.buttons != Buttons::Four && exhibit::asks(visit);
}

float hold_share(const State& state, Instant now, const Options& options) {
    if (!state.hold || options.hold.count() <= 0) return 0;
    const std::chrono::duration<float> held = now - state.hold->since;
    return std::clamp(held / std::chrono::duration<float>(options.hold), 0.0F, 1.0F);
}

exhibit::Timings patient(exhibit::Timings timings, double times) {
    for (auto* time : {&timings.patience, &timings.countdown, &timings.finale, &timings.describe, &timings.long_press})
        *time = std::chrono::milliseconds(std::llround(static_cast<double>(time->count()) * std::max(1.0, times)));
    return timings;
}

}  // namespace quadrat::switches
