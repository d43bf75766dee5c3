// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "base/seed.hpp"
#include "scene/land.hpp"
#include "scene/parameters_fwd.hpp"
#include "synthesis/houses/lanes.hpp"

namespace quadrat::synthesis::houses {

// A lane and where it leaves another; the first ones begin in the middle.
struct Branch {
    Lane lane;
    int from = -1;        // the branch it leaves; -1: the middle, or a road of the land
    float from_at_m = 0;  // along that
};

// How lanes lie to each other: crossing at right angles, in rings and rays, as feet have worn them.
enum class Streets : std::uint8_t { Raster, Radial, Organic };
Streets streets_of(const scene::LandParameters& parameters);

// All lanes that a settlement about this place could ever have: the land's roads near by, a street through the middle
// where there is none, and lanes off them.
std::vector<Branch> grow_network(const scene::Land& land, glm::vec2 middle_m, const scene::LandParameters& parameters,
                                 base::Seed seed);

}  // namespace quadrat::synthesis::houses
