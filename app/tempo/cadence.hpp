// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <optional>

#include "base/display_time.hpp"

namespace quadrat::tempo {

// Frames that are meant to take several refresh periods of the display each, evenly apart.
struct Cadence {
    std::chrono::nanoseconds period{0};
    int periods = 1;                                    // per frame
    base::DisplayTime shown_at{};                       // the last frame that is known to be on the screen
    std::optional<base::DisplayTime> handed_over_at{};  // the one after it, where it is still on its way
};

// When the next frame is to be handed over, so that it is shown so many periods after the one before it: a screen shows
// a frame at the beginning of its first period after that.
base::DisplayTime hand_over_at(const Cadence& cadence);

}  // namespace quadrat::tempo
