// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <vector>

#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "scene/land.hpp"

namespace quadrat::synthesis::land {

// Level, dry ground in the viewer's sight, as flat as the land has it, made flat: a plane of at most kSiteSlope within
// the radius, eased into the land around it. None where all is water. surface_m: of lakes and rivers, scene::kNoWater.
inline constexpr float kSiteSlope = 0.05F;
std::optional<scene::Site> make_site(mesh::Field& height_m, const mesh::Field& surface_m, float cell_m, float radius_m);

struct RoadOptions {
    float width_m = 3.6F;
    float grade = 0.1F;   // that the finished road nowhere passes
    bool goes_on = true;  // beyond the site, where there is one
};

// Roads from edge to edge, or from edge to site and from the site on; on an island from the site to the shore. The
// cheapest way by length, grade and bends, then levelled: its ground is cut and filled until the grade holds. It does
// not run through lakes or the sea, and fords no river it can avoid. Empty where there is no way.
std::vector<scene::Road> make_roads(mesh::Field& height_m, const mesh::Field& surface_m, float cell_m,
                                    const std::optional<scene::Site>& site, const RoadOptions& options,
                                    base::Seed seed);

// To the edge of the nearest road or site, see scene::kept_clear_of().
mesh::Field distance_to_roads_m(int samples, float cell_m, const std::vector<scene::Road>& roads,
                                const std::optional<scene::Site>& site);

}  // namespace quadrat::synthesis::land
