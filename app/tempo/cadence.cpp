// SPDX-License-Identifier: Apache-2.0
#include "tempo/cadence.hpp"

#include <algorithm>

namespace quadrat::tempo {

base::DisplayTime hand_over_at(const Cadence& cadence) {
    const auto [period, periods, shown_at, handed_over_at] = cadence;
    base::DisplayTime before_at = shown_at;
    if (handed_over_at) {
        // It is not shown beside another, nor before it was there: reckoned from what was planned for it instead, one
        // frame that came early would make every other one late.
        const auto passed = (*handed_over_at - shown_at + period - std::chrono::nanoseconds{1}) / period;
        before_at += std::max<decltype(passed)>(passed, 1) * period;
    }
    return before_at + period / 4 + (periods - 1) * period;
}

}  // namespace quadrat::tempo
