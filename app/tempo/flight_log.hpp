// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <vector>

#include "tempo/frame_record.hpp"

namespace quadrat::tempo {

// What a display keeps of a frame between handing it over and seeing it shown. One frame at a time is in flight.
class FlightLog {
  public:
    void handed_over(std::uint64_t number, const HandOver& how, DisplayTime at);
    // The frame in flight reached the screen. Nothing happens where none is.
    void shown(DisplayTime at, nanoseconds period);
    // The screen was away: what is in flight was never seen, and the next frame is compared with none.
    void interrupted();
    std::optional<DisplayTime> in_flight_since() const;
    // Those that were shown since the last call, in order.
    std::vector<FrameRecord> take_finished();

  private:
    std::optional<FrameRecord> in_flight_;
    std::optional<DisplayTime> last_shown_;
    std::vector<FrameRecord> finished_;
};

}  // namespace quadrat::tempo
