// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <optional>

namespace quadrat::tempo {

// Frames that are meant to take several of the screen's periods each, and to be as far apart as each other. All times
// are on the screen's clock.
struct Cadence {
    using Instant = std::chrono::nanoseconds;

    Instant period{0};                        // of the screen's
    int periods = 1;                          // a frame
    Instant shown_at{0};                      // the last frame that is known to be on the screen
    std::optional<Instant> handed_over_at{};  // the one after it, where it is still on its way
};

// When the next frame is to be handed over, so that it is shown so many periods after the one before it: a screen shows
// a frame at the beginning of its first period after that.
Cadence::Instant hand_over_at(const Cadence& cadence);

}  // namespace quadrat::tempo
