// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>

#include "base/display_time.hpp"

namespace quadrat::display {

// CLOCK_MONOTONIC, which the kernel's page flips are stamped with: the one clock of this folder, for deadlines of the
// hardware and for telling when a frame was shown.
std::chrono::nanoseconds monotonic_now();
base::DisplayTime display_now();  // the same

}  // namespace quadrat::display
