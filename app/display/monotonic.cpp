// SPDX-License-Identifier: Apache-2.0
#include "display/monotonic.hpp"

#include <ctime>

namespace quadrat::display {

std::chrono::nanoseconds monotonic_now() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::chrono::seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec};
}

base::DisplayTime display_now() { return base::DisplayTime{monotonic_now()}; }

}  // namespace quadrat::display
