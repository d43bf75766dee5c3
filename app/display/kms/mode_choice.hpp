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

// First the configured mode when the screen offers it; else the preferred one when it is within 1920x1080 at 60 Hz;
// else the largest within that; else, as the screen has nothing so small, its smallest. Then the same without scaling,
// then two ever smaller modes, for a card that lacks memory or bandwidth. draw 0x0: the mode's size.
ModeLadder mode_ladder(std::span<const ScreenMode> modes, const std::optional<WantedMode>& wanted, Size draw);

}  // namespace quadrat::display
