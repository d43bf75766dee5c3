// SPDX-License-Identifier: Apache-2.0
#include "benches/markup.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace quadrat::benches {
std::string bar_of(double solid_share, double pale_share) {
    constexpr double kWidth = 100;
    constexpr double kLeast = 1;  // so that there is something to see
    const double solid = std::clamp(kWidth * solid_share, kLeast, kWidth);
    const double pale = std::clamp(kWidth * pale_share, solid, kWidth);
    return fmt::format(
        R"(<svg class="bar" viewBox="0 0 {0} 8" preserveAspectRatio="none" aria-hidden="true">)"
        R"(<rect class="pale" width="{2:.1f}" height="8"/><rect class="solid" width="{1:.1f}" height="8"/></svg>)",
        kWidth, solid, pale);
}

}  // namespace quadrat::benches
