// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <vector>

#include "render/renderer.hpp"
#include "stage/easel.hpp"

namespace quadrat::benches {

// A pass of ours and the least that others draw the same with (yardstick.hpp), in turns, so that both have the same
// machine. One figure a turn: milliseconds of a frame over the whole picture, the GPU's included.
struct PassTurns {
    std::vector<double> ours_ms;
    std::vector<double> plain_ms;
    std::size_t triangles = 0;  // of a frame of ours
};

// Nothing but the ground of the picture's first view, seen from 40 m higher, beside a plain one of so many squares a
// side.
PassTurns land_pass(stage::Easel& easel, const render::Frame& picture, int squares_a_side, int turns);
// Nothing but the sky of that view.
PassTurns sky_pass(stage::Easel& easel, const render::Frame& picture, int turns);

// The median of what each turn needed beside the other's in the same turn.
double ratio_of(const PassTurns& turns);

}  // namespace quadrat::benches
