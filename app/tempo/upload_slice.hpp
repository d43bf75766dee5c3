// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <optional>

namespace quadrat::tempo {

// How much of a frame's time goes to what is brought to the GPU.
struct UploadSlices {
    std::chrono::nanoseconds awaited{0};             // where a visitor waits for it: an eighth of the frame's time
    std::optional<std::chrono::nanoseconds> idle{};  // else; nothing: in this frame none
};

// Goes by what drawing the last few frames took. Where nobody waits, uploads leave the frame under two milliseconds,
// and what drawing leaves.
class UploadSlice {
  public:
    using nanoseconds = std::chrono::nanoseconds;
    static constexpr int kShare = 8;  // of a frame's time, at most one of so many parts
    static constexpr nanoseconds kMost = std::chrono::microseconds{1500};  // where nobody waits, and its last piece
    // Where nobody waits, uploads skip at most so many busy frames in a row. The next one takes its share all the same:
    // a visitor may soon wait for it.
    static constexpr int kMostPutOff = 1;

    // A frame's drawing was finished after so long.
    void drew(nanoseconds took);
    // For the next frame, which is meant to take frame_time.
    UploadSlices next(nanoseconds frame_time) const;
    // What the slices that were told last were used for.
    void used(const UploadSlices& slices, bool was_awaited);

  private:
    static constexpr nanoseconds kPiece = std::chrono::milliseconds{2};  // that the last one may take after its time
    std::array<nanoseconds, 4> drew_{};
    std::size_t frames_ = 0;
    int put_off_ = 0;  // frames in a row
};

}  // namespace quadrat::tempo
