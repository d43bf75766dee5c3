// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "tempo/governor.hpp"

// What a GPU can draw, found before anybody watches, so that the governor starts near where it would end.
namespace quadrat::tempo {

// One way to draw a frame, and what it took.
struct FrameCost {
    float alpha = 1;
    float scale = 1;
    int samples = 1;
    double ms = 0;
    double triangles = 0;
};

// A frame's time as a sum: what it always takes, its triangles, and the pixels of its views.
struct GpuProfile {
    double always_ms = 0;
    double triangles_per_s = 0;
    double pixels_per_s = 0;
    int samples = 1;                // a pixel, for smooth edges; 1: there are none
    double smooth_ms = 0;           // which take so much more
    double upload_bytes_per_s = 0;  // 0: not measured
    // Triangles are taken to follow alpha between these two.
    FrameCost much;
    FrameCost little;
    double pixels = 0;

    double frame_ms(float alpha, float scale) const;
};

// much: at a high alpha, little: at a low one, small: that one at half the scale, smooth: the first with several
// samples a pixel, or with one where there are none; of a frame of so many pixels. Where a difference is lost in noise,
// what it stands for is taken to be free.
struct FrameCosts {
    FrameCost much, little, small, smooth;
};
GpuProfile profile_of(const FrameCosts& costs, double pixels);

// For people, and for the state: its rates in one line.
std::string to_text(const GpuProfile& profile);

// Where to start: the most detail, up to `most`, that leaves three tenths of the screen's period, or of two to four
// where fewer cannot be held at all; and smooth edges where they leave as much beside all that is asked for.
GovernorOptions start_for(const GpuProfile& profile, float most, double period_ms);

}  // namespace quadrat::tempo
