// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "display/display.hpp"

namespace quadrat::display {

// Whether a picture of one size fills the other without being stretched: to one part in seventy, which is what 1360x768
// and 1366x768 are apart.
bool is_same_shape(Size a, Size b);

struct Placement {
    int x = 0, y = 0;
    Size size;
    friend bool operator==(const Placement&, const Placement&) = default;
};

// Where a picture is shown in a mode: as large as it fits, in the middle, its aspect kept. Both at least 1x1.
Placement placed_in(Size mode, Size picture);

// What is drawn for a mode when nobody says otherwise: its own size as far as that is not much more work than full HD
// (1920x1200), else the largest of its very shape that is no more work than that, both sides even.
Size drawn_for(Size mode);

}  // namespace quadrat::display
