// SPDX-License-Identifier: Apache-2.0
#include "display/kms/placement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>

namespace quadrat::display {
namespace {

constexpr std::int64_t kMostDrawnAsIs = 1920 * 1200;
constexpr std::int64_t kMostDrawn = 1920 * 1080;

std::int64_t area(Size size) { return std::int64_t{size.width} * size.height; }

int even(double side) { return std::max(2, static_cast<int>(side / 2.0) * 2); }

}  // namespace

bool is_same_shape(Size a, Size b) {
    const std::int64_t one = std::int64_t{a.width} * b.height, other = std::int64_t{b.width} * a.height;
    return std::abs(one - other) * 70 <= std::max(one, other);
}

Placement placed_in(Size mode, Size picture) {
    const std::int64_t as_wide = std::int64_t{mode.width} * picture.height;  // the mode's shape against the picture's
    const std::int64_t as_high = std::int64_t{mode.height} * picture.width;
    Size size = mode;
    if (as_wide > as_high) size.width = static_cast<int>(as_high / picture.height);
    if (as_high > as_wide) size.height = static_cast<int>(as_wide / picture.width);
    // Bars so thin are the rounding of the picture's own size.
    const auto is_rounding = [](int bar, int side) { return bar <= std::max(2, side / 400); };
    if (is_rounding(mode.width - size.width, mode.width) && is_rounding(mode.height - size.height, mode.height))
        size = mode;
    return {(mode.width - size.width) / 2, (mode.height - size.height) / 2, size};
}

Size drawn_for(Size mode) {
    if (area(mode) <= kMostDrawnAsIs) return mode;
    const double scale = std::sqrt(static_cast<double>(kMostDrawn) / static_cast<double>(area(mode)));
    const int common = std::gcd(mode.width, mode.height);
    const Size shape{mode.width / common, mode.height / common};
    int steps = static_cast<int>(common * scale + 1e-9);
    while (steps > 0 && (shape.width * steps % 2 != 0 || shape.height * steps % 2 != 0)) --steps;
    constexpr int kFewest = 16;  // of an odd shape that has only few exact sizes, the nearest even ones will do
    if (steps >= kFewest) return {shape.width * steps, shape.height * steps};
    return {even(mode.width * scale), even(mode.height * scale)};
}

}  // namespace quadrat::display
