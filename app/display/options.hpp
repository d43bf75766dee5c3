// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "display/display.hpp"

namespace quadrat::display {

// A mode as people write it. refresh_hz 0: any.
struct WantedMode {
    Size size;
    double refresh_hz = 0.0;
    friend bool operator==(const WantedMode&, const WantedMode&) = default;
};

// "1920x1080", "1920x1080@60", "1920x1080@59.94"; empty text: nothing wanted. Throws InputError naming what.
std::optional<WantedMode> mode_from(std::string_view text, std::string_view what);

// Throws InputError for a size or a mode that no display here can have.
void check(const DisplayOptions& options);

}  // namespace quadrat::display
