// SPDX-License-Identifier: Apache-2.0
#include "display/shown_frames.hpp"

#include <utility>

namespace quadrat::display {

std::vector<std::chrono::nanoseconds> ShownFrames::since_last(const Presented& presented) {
    const std::uint64_t before = std::exchange(frame_, presented.shown_frame);
    const std::chrono::nanoseconds at_before = std::exchange(at_, presented.shown_at);
    if (frame_ <= before) return {};
    // More were never shown: the screen was away.
    if (before == 0 || frame_ - before != 2) return {at_};
    return {at_before + (at_ - at_before) / 2, at_};
}

}  // namespace quadrat::display
