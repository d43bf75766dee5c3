// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/kernel_clock.hpp"

#include <algorithm>

namespace quadrat::firmware_io {
namespace {

// No edge waits longer than this to be read: beyond it one of the clocks was set, and the estimate begins anew.
constexpr Instant kLongestWait = std::chrono::seconds{10};

}  // namespace

void KernelClock::saw(Instant kernel_time, Instant now) {
    const Instant distance = now - kernel_time;
    if (!distance_ || distance - *distance_ > kLongestWait) distance_ = distance;
    distance_ = std::min(*distance_, distance);
}

}  // namespace quadrat::firmware_io
