// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "synthesis/land/layered_ground.hpp"

namespace quadrat::synthesis::land {

// A fin of bedded rock, longer east to west than it is broad, weathered under its hard beds.
struct OverhangShape {
    float height_m = 14;  // over the ground, 4 to 40
    float recess = 0.7F;  // how far the softest bed has gone back, to half the fin's breadth: from 1 on it is pierced
    float bed_m = 3;      // thickness of a bed, about
    float sand = 0.5F;    // share of what fell that still lies at its foot
};

// Ground that is level at 0 m as far as sand runs, with the fin on it: alcoves under hard beds, windows and arches
// where the fin is thin, sand at its foot that is no steeper than it can be. Rock that hung on nothing has fallen.
LayeredGround weathered_fin(const OverhangShape& shape, base::Seed seed);

}  // namespace quadrat::synthesis::land
