// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "mesh/field.hpp"

namespace quadrat::synthesis::land {

// Where water goes. Every cell has a way, by receivers, to an outlet: a cell of the border or one at or below the sea.
struct Drainage {
    mesh::Field spill_m;                 // the height water stands at: the ground, or the level its hollow spills at
    std::vector<std::int32_t> receiver;  // a cell: the cell it drains to; an outlet: itself
    std::vector<std::int32_t> order;     // every cell once, receivers before what drains to them
    std::vector<float> drained_cells;    // how many drain through each, itself included
};

// Water leaves a cell by its steepest way down, which chance of the place and of the number wander disturbs, so that
// the grid's eight directions do not show; from the floor of a hollow it leaves over the lowest pass, up the way it
// would have come down. Spill levels are those of a priority flood. sea_m: cells not above it are outlets; the border
// always is.
Drainage drain(const mesh::Field& height_m, float sea_m, std::uint32_t wander = 0);

// drained_cells times cell_m squared.
std::vector<float> drained_area_m2(const Drainage& drainage, float cell_m);

}  // namespace quadrat::synthesis::land
