// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "scene/land.hpp"
#include "scene/parameters_fwd.hpp"
#include "synthesis/houses/settle.hpp"

namespace quadrat::synthesis::houses {

// Where a way meets water: from one bank to the other.
struct Span {
    glm::vec2 from_m{0}, to_m{0};
    float width_m = 2.6F;
    float deepest_m = 0;  // of the water
    float surface_m = 0;
};
// Up to so deep one wades: there are stepping stones.
inline constexpr float kFord_m = 0.32F;

// Of the land's roads within reach of a settlement, and of its lanes.
std::vector<Span> spans_of(const scene::Land& land, const Settled& settled);

// Bridges, an arch of stone or of wood as the region builds, and fords, a piece each, where they stand.
std::vector<scene::Masses> add_bridges(const scene::Land& land, const Settled& settled,
                                       const scene::LandParameters& parameters);

}  // namespace quadrat::synthesis::houses
