// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "base/seed.hpp"
#include "scene/parameters_fwd.hpp"
#include "scene/sky.hpp"

namespace quadrat::synthesis::sky {

mesh::Image sun_picture(int side_px);

// phase: share of the disc that is lit, 0 new to 1 full; lit from the right. Its seas are the seed's.
mesh::Image moon_picture(int side_px, float phase, base::Seed seed);

// Stars above the horizon, brightest first: as many of each magnitude as the real sky has (ten times as many for two
// magnitudes more), closer together along the Milky Way. None by day.
std::vector<scene::Star> make_stars(const scene::SkyParameters& parameters, float darkness, base::Seed seed);

}  // namespace quadrat::synthesis::sky
