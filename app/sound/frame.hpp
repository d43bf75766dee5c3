// SPDX-License-Identifier: Apache-2.0
// The room `sound`: what is heard. A landscape's soundscape, signals, speech, their mix, and the card they are played
// on. Nothing here knows of visits, screens or languages: it is told what to play.
#pragma once
#include <cstdint>
#include <span>

namespace quadrat::sound {

inline constexpr int kRate = 48'000;  // frames per second

// One moment of both channels, -1 to 1 where it can be played.
struct Frame {
    float left = 0;
    float right = 0;
    Frame& operator+=(const Frame& other) {
        left += other.left;
        right += other.right;
        return *this;
    }
    friend bool operator==(const Frame&, const Frame&) = default;
};
inline Frame operator*(const Frame& frame, float gain) { return {frame.left * gain, frame.right * gain}; }

using Block = std::span<Frame>;
using FrameIndex = std::int64_t;  // since something began

constexpr FrameIndex floor_div(FrameIndex a, FrameIndex b) { return a / b - (a % b < 0 ? 1 : 0); }  // b > 0
constexpr FrameIndex frames_of(double seconds) { return static_cast<FrameIndex>(seconds * kRate); }

}  // namespace quadrat::sound
