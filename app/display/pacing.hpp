// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <optional>

namespace quadrat::display {

// Whether a frame that was handed over is waited for before the next one is begun. Waiting takes a whole frame off the
// time from a press to the picture, but leaves processor and GPU one frame between them, and none for a hiccup. Where a
// frame came late that would not have, had it been begun a frame earlier, frames are drawn ahead for a while; then
// waiting is tried again, after ever longer times as long as it fails.
class Pacing {
  public:
    using Instant = std::chrono::nanoseconds;

    bool waits(Instant now) const { return now >= ahead_until_; }
    // A frame reached the screen. `period` is the screen's.
    void shown(Instant at, Instant period);
    // What comes next is not compared with what was: the screen was away.
    void interrupted() { last_.reset(); }

  private:
    std::optional<Instant> last_;
    Instant ahead_until_{0};
    Instant ahead_for_ = std::chrono::seconds{5};
    int lateness_ = 0;  // a late frame counts until eight in a row were not
    int in_time_ = 0;
};

}  // namespace quadrat::display
