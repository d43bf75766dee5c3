// SPDX-License-Identifier: Apache-2.0
#include "kiosk/detail/memory.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace quadrat::kiosk {

std::string to_text(const DetailGovernor& governor, const display::Display& screen) {
    return fmt::format("{} {:.4f} {}", governor.periods(), governor.settled(), screen.renderer());
}

GovernorOptions options_for(float most, std::string_view remembered, const display::Display& screen) {
    GovernorOptions options;
    options.most = options.start = most;
    const char* const end = remembered.data() + remembered.size();
    int periods = 0;
    const auto first = std::from_chars(remembered.data(), end, periods);
    if (first.ec != std::errc{} || first.ptr == end || periods < 1 || periods > 2) return options;
    float alpha = 0;
    const auto second = std::from_chars(first.ptr + 1, end, alpha);
    if (second.ec != std::errc{} || second.ptr == end || !std::isfinite(alpha) || alpha <= 0) return options;
    if (std::string_view(second.ptr + 1, static_cast<std::size_t>(end - second.ptr - 1)) != screen.renderer())
        return options;
    options.start = alpha;
    options.periods = periods;
    return options;
}

}  // namespace quadrat::kiosk
