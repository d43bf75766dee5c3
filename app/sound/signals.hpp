// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "sound/frame.hpp"

namespace quadrat::sound {

// What a visit sounds with. Each is told from the others by its rhythm as well as by its pitch.
enum class Signal : std::size_t {
    Press,       // a button was heard: a knock, A to D rising
    Back,        // the same of Back: two knocks that fall
    Mark,        // the mark has come to a choice: a soft tick, A to D rising
    Choice,      // an answer was taken: two notes that rise
    Round,       // the next four are here: three notes
    Finale,      // what was bred is here: a chord that opens
    StillThere,  // two soft notes, asking
    count
};

// place: of A to D, 0 to 3, and 4 for Back: its pitch, and where it is heard. Adds to the block what of the signal
// falls there; it began at frame 0. Within -1 to 1.
void add_signal(Block block, FrameIndex first, Signal signal, int place);
FrameIndex frames_of(Signal signal);

}  // namespace quadrat::sound
