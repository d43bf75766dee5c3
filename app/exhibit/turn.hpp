// SPDX-License-Identifier: Apache-2.0
// Between the files that make one visit; nobody else includes it.
#pragma once
#include "exhibit/visit.hpp"

namespace quadrat::exhibit {

// One event's work: the state being changed and the wishes so far.
struct Turn {
    State state;
    std::vector<Wish> wishes;
    Instant now;
    const Timings& timings;
};

inline constexpr int kTurnsARound = 3;  // of sliders; as many as answers

void show(Turn& turn, Screen screen);
int new_generation(State& state);
void breed(Turn& turn, Screen after);
void grow_finale(Turn& turn, const genome::Pick& answers);
enum class NextVisit { ToPrepare, Prepared };
void end_visit(Turn& turn, Ending ending, NextVisit next_visit);

// visit_finale.cpp
void show_finale(Turn& turn);
void leave_finale(Turn& turn);
void press_in_finale(Turn& turn, Choice button);
void press_in_family(Turn& turn, Choice button);
void press_in_describe(Turn& turn, Choice button);

// visit_slide.cpp
void press_in_slide(Turn& turn, Choice button);

}  // namespace quadrat::exhibit
