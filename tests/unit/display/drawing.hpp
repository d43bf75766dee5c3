// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <epoxy/gl.h>

#include <array>
#include <cstdint>
#include <vector>

#include "display/display.hpp"

namespace quadrat::display::testing {

using Pixel = std::array<std::uint8_t, 4>;

// Four rectangles in four colours over a fifth: what must look the same on every display. Bottom row first, as GL has
// it.
void draw_four_quarters(const Canvas& canvas);
std::vector<Pixel> read_back(const Canvas& canvas);

}  // namespace quadrat::display::testing
