// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "firmware-io/button_press.hpp"

namespace quadrat::firmware_io {

// Tells the moment of a kernel timestamp on the exhibit's clock without reading any clock. An edge can never be seen
// before it happened, so the smallest difference seen so far between when we looked and what the kernel wrote is the
// best estimate of the distance between the two zeros: never too small, and exact but for the time that the promptest
// edge waited.
class KernelClock {
  public:
    // An edge that the kernel stamped `kernel_time` was read at `now`. Shown all edges of a poll first, the clock keeps
    // the distances between them even when they waited long.
    void saw(Instant kernel_time, Instant now);

    // The moment of an edge that was shown to saw(): never later than the `now` given there.
    Instant moment_of(Instant kernel_time) const { return kernel_time + distance_.value_or(Instant{0}); }

  private:
    std::optional<Instant> distance_;
};

}  // namespace quadrat::firmware_io
