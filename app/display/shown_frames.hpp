// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <cstdint>
#include <vector>

#include "display/display.hpp"

namespace quadrat::display {

// When frames reached the screen. present() tells of the latest: where frames are drawn ahead that is the one before,
// where it changes to that none that is new, and two at once where it changes back.
class ShownFrames {
  public:
    // Those since the last call, in order; of two at once, the first in the middle.
    std::vector<std::chrono::nanoseconds> since_last(const Presented& presented);

  private:
    std::uint64_t frame_ = 0;
    std::chrono::nanoseconds at_{0};
};

}  // namespace quadrat::display
