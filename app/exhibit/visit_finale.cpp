// SPDX-License-Identifier: Apache-2.0
// What a visit ends with: the landscape, how it came about, and what it is called. From here it may go on.
#include <algorithm>

#include "exhibit/family.hpp"
#include "exhibit/turn.hpp"

namespace quadrat::exhibit {
namespace {

bool is_guarded(const Turn& turn) { return turn.now - turn.state.since < turn.timings.press_guard; }

void go_on_from(Turn& turn, int node) {
    State& state = turn.state;
    if (state.family.size() >= kMostFamily) return;
    state.here = node;
    state.past_answers = picks_to(state.family, node);
    state.rounds = static_cast<int>(state.past_answers.size());
    state.question = genome::Aspect::Trees;
    turn.wishes.emplace_back(ReturnTo{new_generation(state), node});
    breed(turn, Screen::Ask);
}

void print(Turn& turn) {
    if (!turn.timings.can_print || turn.state.is_printed) return;
    turn.state.is_printed = true;
    turn.wishes.emplace_back(PrintPostcard{});
}

}  // namespace

void show_finale(Turn& turn) {
    turn.state.finale_asks = turn.timings.finale_asks && !turn.state.family.empty();
    turn.state.is_printed = false;
    show(turn, Screen::Finale);
    if (turn.timings.prints_all) print(turn);
}

void leave_finale(Turn& turn) {
    const Timings& timings = turn.timings;
    if (timings.describe_words > 0 && turn.state.finales % std::max(1, timings.describe_every) == 0) {
        show(turn, Screen::Describe);
        return;
    }
    end_visit(turn, Ending::Finished, NextVisit::Prepared);
}

void press_in_finale(Turn& turn, Choice button) {
    // An impatient press at what was still growing must not cost the visitor their landscape.
    if (turn.now - turn.state.since < turn.timings.finale_guard) return;
    if (!turn.state.finale_asks) return leave_finale(turn);
    switch (button) {
        case Choice::A:
            turn.state.walked = turn.state.here;
            return show(turn, Screen::Family);
        case Choice::B:
            return go_on_from(turn, turn.state.here);
        case Choice::C:
            return print(turn);
        case Choice::D:
        case Choice::Back:
            return leave_finale(turn);
    }
}

void press_in_family(Turn& turn, Choice button) {
    if (is_guarded(turn)) return;
    State& state = turn.state;
    if (button == Choice::Back) return show(turn, Screen::Finale);
    if (button == Choice::D) return go_on_from(turn, state.walked);
    if (const auto to = step_to(state.family, state.walked, button, state.here)) {
        state.walked = *to;
        show(turn, Screen::Family);
    }
}

void press_in_describe(Turn& turn, Choice button) {
    if (is_guarded(turn)) return;
    if (button != Choice::Back) {
        turn.wishes.emplace_back(KeepWord{turn.state.described, static_cast<std::size_t>(button)});
        if (++turn.state.described < turn.timings.describe_words) return show(turn, Screen::Describe);
    }
    end_visit(turn, Ending::Finished, NextVisit::Prepared);
}

}  // namespace quadrat::exhibit
