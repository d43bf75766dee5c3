// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "firmware-io/button_press.hpp"

namespace quadrat::firmware_io::gpio {

// Tells the moment of a kernel timestamp on the exhibit's clock without reading any clock. An edge can never be seen
// before it happened, so the smallest difference seen so far between when we looked and what the kernel wrote is the
// best estimate of the distance between the two zeros: never too small, and exact but for the time that the promptest
// edge waited. Distances between edges are the kernel's from the first one on.
class KernelClock {
  public:
    // The moment of `kernel_time`, seen at `now`: never later than `now`.
    Instant moment_of(Instant kernel_time, Instant now);

  private:
    std::optional<Instant> distance_;
};

}  // namespace quadrat::firmware_io::gpio
