// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "base/clock.hpp"
#include "kiosk/run_loop.hpp"

namespace quadrat::benches {

struct FrameSeen {
    base::Instant at{0};
    base::Instant took{0};      // since the frame before it reached the screen
    base::Instant deadline{0};  // what it was meant to take
    base::Instant period{0};    // of the screen's
    float level = 1;
    bool is_growing = false;
    int act = 0;                   // on stage
    base::Instant since_press{0};  // of the first frame that shows a new generation; else 0
    bool is_late = false;          // see tempo::is_late
};

// SVG: how long each frame took, when landscapes grew and came, and what the governor made of it, with a mark for each
// of its decisions that says why where a viewer's pointer rests on it. Black on white, unless a page that it stands in
// gives the classes paper, growing and took other colours.
std::string plot_of(const std::vector<FrameSeen>& frames, const std::vector<kiosk::RunRecord::Decision>& decisions);

}  // namespace quadrat::benches
