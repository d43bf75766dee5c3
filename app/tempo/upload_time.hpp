// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "base/clock.hpp"

namespace quadrat::tempo {

// How much of each frame's time goes to what is brought to the GPU: an eighth where a visitor waits for it, and else no
// more than leaves it under two milliseconds, and than drawing leaves. It is asked before drawing, and goes by what the
// last few frames took.
class UploadTime {
  public:
    static constexpr int kShare = 8;  // of a frame's time, at most one of so many parts
    static constexpr base::Instant kMost =
        std::chrono::microseconds{1500};  // for what nobody waits for, and its last piece
    // What nobody waits for lets so many frames go by that have no time for it. The next one takes its share all the
    // same: a visitor may soon wait for it.
    static constexpr int kMostPutOff = 1;

    // A frame's drawing was finished after so long.
    void drew(base::Instant took);
    // For the next frame, which is meant to take frame_time. Nothing: in this frame none.
    std::optional<base::Instant> next(base::Instant frame_time, bool is_waited_for);

  private:
    static constexpr base::Instant kPiece = std::chrono::milliseconds{2};  // that the last one may take after its time

    std::array<base::Instant, 4> drew_{};
    std::size_t frames_ = 0;
    int put_off_ = 0;  // frames in a row
};

}  // namespace quadrat::tempo
