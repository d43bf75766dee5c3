// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <optional>

#include "tempo/frame_record.hpp"

namespace quadrat::tempo {

// Whether a frame that was handed over is waited for before the next one is begun. Waiting takes a whole frame off the
// time from a press to the picture, but leaves processor and GPU one frame between them, and none for a hiccup. If a
// frame came late that would have been in time had it been begun a frame earlier, frames are drawn ahead for a while;
// then waiting is tried again, after ever longer times as long as it fails. A frame's time is what it is meant to take:
// several refresh periods where the machine is slow.
class DrawAhead {
  public:
    bool waits(DisplayTime now) const { return now >= ahead_until_; }
    void shown(const FrameRecord& record);

  private:
    DisplayTime ahead_until_{};
    nanoseconds ahead_for_ = std::chrono::seconds{5};
    int lateness_ = 0;  // a late frame counts until eight in a row were not
    int in_time_ = 0;
};

}  // namespace quadrat::tempo
