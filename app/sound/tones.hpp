// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>

#include "sound/frame.hpp"

// What sounds are made of, of sums and products alone: the same bits on every processor.
namespace quadrat::sound {

// sin(2 pi turns), within 0.0012. turns: any number that a float holds to a thousandth.
inline float sine(float turns) {
    const float t = turns - std::floor(turns) - 0.5F;  // -0.5 to 0.5, half a turn behind
    const float parabola = 8.0F * t * (2.0F * std::abs(t) - 1.0F);
    return parabola * (0.775F + 0.225F * std::abs(parabola));
}

// 1 at 0, about a thousandth at 1, exactly 0 from there on: how a struck thing dies away.
inline float dying(float share) {
    if (share >= 1) return 0;
    const float rest = 1.0F - share;
    const float squared = rest * rest;
    return squared * squared * rest;
}

// 0 outside of 0 to 1, a smooth hill within.
inline float hill(float share) {
    if (share <= 0 || share >= 1) return 0;
    const float away = 2.0F * share - 1.0F;
    const float rest = 1.0F - away * away;
    return rest * rest;
}

inline float smooth_step(float share) {
    const float x = std::clamp(share, 0.0F, 1.0F);
    return x * x * (3.0F - 2.0F * x);
}

// 0 at or below low, 1 at or above high.
inline float share_of(float value, float low, float high) {
    return std::clamp((value - low) / (high - low), 0.0F, 1.0F);
}

// pan: -1 left to 1 right. Power stays the same within a tenth.
inline Frame panned(float value, float pan) {
    const float right = 0.5F + 0.5F * std::clamp(pan, -1.0F, 1.0F);
    return {value * std::sqrt(1.0F - right), value * std::sqrt(right)};
}

}  // namespace quadrat::sound
