// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <string>

#include "benches/benches.hpp"
#include "benches/four_views.hpp"
#include "stage/detail_within.hpp"
#include "stage/easel.hpp"

namespace quadrat::benches {

// Pixels that are shaded for each render::DrawnKind, those that are drawn over later too.
using ShadedPixels = std::array<double, render::kDrawnKinds>;
// Of a part of each view, or of all: its sky is what no nearer thing of that part hides.
ShadedPixels shaded_pixels(stage::Easel& easel, const render::Frame& picture,
                           render::choose::Reach::Part part = render::choose::Reach::Part::Whole, float split_m = 0);

// Instructions of the dearest shaders of a kind on a Raspberry Pi, as Mesa 25.0.7 compiles them: for a pixel, and for a
// vertex in rendering and in binning, which both are done. The shader is the one of the pair that no other pair has.
struct ShaderCosts {
    const char* shader;
    int fragment;
    int vertex;
    int binning;
};
using ChipCosts = std::array<ShaderCosts, render::kDrawnKinds>;
extern const ChipCosts kPi4Costs;
extern const ChipCosts kPi5Costs;
// Where a sky is drawn for frames to come, sky.frag's costs; each of those fetches it, at the costs of its kind.
extern const ShaderCosts kPi4Dome;
extern const ShaderCosts kPi5Dome;

// Where what is far and the sky are shown as they were held.
extern const ShaderCosts kPi4Distance;
extern const ShaderCosts kPi5Distance;

// What a frame of four flights would take on a Raspberry Pi, at 60 Hz and at their mean speed, with everything that is
// assumed as rows of its own; and what it would take if nothing far were held.
void estimate(Results& results, const std::string& profile, FourViews& views);

}  // namespace quadrat::benches
