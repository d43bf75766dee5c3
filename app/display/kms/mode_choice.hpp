// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "display/kms/card.hpp"
#include "display/options.hpp"

namespace quadrat::display {

// One way to put a picture on a screen: a mode of it, and the pixels drawn, which the plane scales when they differ.
struct Rung {
    std::size_t mode = 0;  // index into the screen's modes
    Size draw;
    friend bool operator==(const Rung&, const Rung&) = default;
};

struct ModeLadder {
    std::vector<Rung> rungs;  // best first; the next is tried when the card refuses one. Empty without modes.
    std::string warning;      // when the configured mode is not offered; empty otherwise
};

// First the configured mode when the screen offers it; else the preferred size, at up to 60 Hz, within what HDMI and
// scan-out carry (4096x2160 at 60 Hz); else the largest of the preferred one's shape within that. Another shape only
// where there is none of it, or no preferred one. What is drawn for it is at most about full HD (placement.hpp), and
// the plane scales it. Then, for a card that lacks scaling, memory or bandwidth: at half the rate, without scaling, and
// two ever smaller modes of the panel's shape. draw 0x0: what suits the mode.
ModeLadder mode_ladder(std::span<const ScreenMode> modes, const std::optional<WantedMode>& wanted, Size draw);

}  // namespace quadrat::display
