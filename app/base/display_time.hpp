// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>

namespace quadrat::base {

// Display time: CLOCK_MONOTONIC, which the kernel stamps page flips with. A type of its own, so that it is never
// compared with program time: frames are timed by it however fast the program's clock runs.
struct DisplayClock {
    using rep = std::chrono::nanoseconds::rep;
    using period = std::chrono::nanoseconds::period;
    using duration = std::chrono::nanoseconds;
    using time_point = std::chrono::time_point<DisplayClock, duration>;
    static constexpr bool is_steady = true;
};
using DisplayTime = DisplayClock::time_point;

}  // namespace quadrat::base
