// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "scene/land.hpp"
#include "scene/parameters_fwd.hpp"
#include "synthesis/land/ground.hpp"

namespace quadrat::synthesis::land {

// What stones need to know of the land they lie on; its roads and waters are made already.
struct StoneGround {
    const scene::Land& land;  // heights, waters, roads
    const mesh::Field& over_water_m;
    const Palette& palette;
};

// Where a stone stands, for what it keeps dark beneath it.
struct Footprint {
    glm::vec2 at_m{0};
    float radius_m = 0;
};

struct Stones {
    scene::Stone stone;
    std::vector<Footprint> footprints;
    std::vector<scene::Landmark> landmarks;  // caves, then arches or a fin, then rock in steps or the ring of a site
    std::vector<Footprint> forecourts;       // ground before caves that nothing may grow on
};

// Boulders where the ground is steep and stony or falls to the shore; where the genes ask for them natural arches, feet
// in the ground, on stony slopes and shores in the viewer's sight where there are any, or for low ones a fin that
// weather has undercut (layered ground), and caves in rock that stands out of a slope (the overhangs of Peytavie et al.
// 2009, as meshes of their own); on a site a ring of hewn stones, or where the genes ask for it rock in steps. No more
// than some thousand triangles.
Stones make_stones(const StoneGround& ground, const scene::LandParameters& parameters, base::Seed seed);

// Darkens the ground under and around stones.
void shade_under(mesh::Image& albedo, float side_m, const std::vector<Footprint>& footprints);

}  // namespace quadrat::synthesis::land
