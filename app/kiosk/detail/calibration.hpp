// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>

#include "kiosk/detail/governor.hpp"

// What a GPU can draw, found before anybody watches, so that the governor starts near where it would end.
namespace quadrat::kiosk {

// One way to draw a frame, and what it took.
struct FrameCost {
    float alpha = 1;
    float scale = 1;
    double ms = 0;
    double triangles = 0;
};

// A frame's time as a sum: what it always takes, its triangles, and the pixels of its views.
struct GpuProfile {
    double always_ms = 0;
    double triangles_per_s = 0;
    double pixels_per_s = 0;
    // Triangles are taken to follow alpha between these two.
    FrameCost much;
    FrameCost little;
    double pixels = 0;

    double frame_ms(float alpha, float scale) const;
};

// much: at a high alpha, little: at a low one, small: that one at half the scale; of a frame of so many pixels. Where a
// difference is lost in noise, what it stands for is taken to be free.
GpuProfile profile_of(const FrameCost& much, const FrameCost& little, const FrameCost& small, double pixels);

// Where to start: the most detail, up to `most`, that leaves three tenths of the screen's period, or of two periods
// where one cannot be held at all.
GovernorOptions start_for(const GpuProfile& profile, float most, double period_ms);

}  // namespace quadrat::kiosk
