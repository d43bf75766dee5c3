// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "synthesis/houses/building.hpp"

// What stands on, at and astride a house under its roof. Not for use from outside.
namespace quadrat::synthesis::houses {

// Where the roof is high, so that each stands over the ridge's draught.
void add_chimneys(scene::Building& to, const Design& design, double ridge_m, base::Seed seed);
void add_dormers(scene::Building& to, const Design& design, base::Seed seed);
void add_lean_tos(scene::Building& to, const Design& design);
// A bell tower astride the front, under a steep pyramid.
void add_tower(scene::Building& to, const Design& design, base::Seed seed);

}  // namespace quadrat::synthesis::houses
