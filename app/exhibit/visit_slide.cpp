// SPDX-License-Identifier: Apache-2.0
// One slider after another, turned in place of picks.
#include <algorithm>

#include "exhibit/turn.hpp"

namespace quadrat::exhibit {
namespace {

void turn_slider(Turn& turn, int direction) {
    State& state = turn.state;
    ++state.turns;
    ++state.turns_to_undo;
    state.rounds = state.turns / kTurnsARound;
    turn.wishes.emplace_back(TurnSlider{new_generation(state), state.slider, direction});
    if (state.rounds >= turn.timings.rounds) grow_finale(turn, {});
}

void take_turn_back(Turn& turn) {
    State& state = turn.state;
    if (state.turns_to_undo == 0) return;
    --state.turns_to_undo;
    state.rounds = --state.turns / kTurnsARound;
    turn.wishes.emplace_back(UndoTurn{new_generation(state)});
}

}  // namespace

void press_in_slide(Turn& turn, Choice button) {
    // Only as the screen comes: whoever turns sliders presses fast.
    if (turn.now - turn.state.since < turn.timings.press_guard) return;
    const int sliders = std::max(1, turn.timings.sliders);
    switch (button) {
        case Choice::A:
            turn.state.slider = (turn.state.slider + sliders - 1) % sliders;
            return;
        case Choice::B:
            turn.state.slider = (turn.state.slider + 1) % sliders;
            return;
        case Choice::C:
            return turn_slider(turn, -1);
        case Choice::D:
            return turn_slider(turn, 1);
        case Choice::Back:
            return take_turn_back(turn);
    }
}

}  // namespace quadrat::exhibit
