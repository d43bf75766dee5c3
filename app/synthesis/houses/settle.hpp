// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "base/seed.hpp"
#include "mesh/image.hpp"
#include "scene/land.hpp"
#include "scene/parameters_fwd.hpp"
#include "synthesis/houses/lanes.hpp"

namespace quadrat::synthesis::houses {

// How many houses a settlement of this age has: 0 below 0, one at 0, up to kMostHouses at 1.
inline constexpr int kMostHouses = 300;
int houses_at(float age);

// A settlement as it stands, and what the ground must know of it.
struct Settled {
    scene::Settlement settlement;
    std::vector<Lane> lanes;  // those that its houses stand along
    glm::vec2 middle_m{0};
    float reach_m = 0;  // of its outermost house
};

// Grows a settlement house by house, as Weber et al. 2009 let cities grow in steps: the best plot that a lane offers is
// built on next, and lanes are added as plots run out. A younger settlement is the beginning of an older one. No two
// houses overlap; none stands in water or on a road; each looks at the lane it stands along. Empty below age 0 and
// where there is no place for it.
Settled settle(const scene::Land& land, const scene::LandParameters& parameters, base::Seed seed);

// Makes the ground level under houses and along lanes, eased into the land around, and puts the houses on it.
void level_ground(scene::Land& land, Settled& settled);

}  // namespace quadrat::synthesis::houses
