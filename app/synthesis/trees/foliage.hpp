// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "base/seed.hpp"
#include "scene/flora.hpp"
#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

struct FoliageOptions {
    std::size_t blades = 2000;
    float length_m = 0.5F;
    float width = 0.5F;                   // of a blade to its length
    float fold = 0.25F;                   // depth of the midrib's fold to the length
    float scatter_m = 0.3F;               // about a site
    float droop = 0.2F;                   // blades hang: 0 not at all to 1 straight down
    glm::vec3 colour{0.1F, 0.2F, 0.05F};  // linear, of the crown's light side
    glm::vec3 second{0.2F, 0.2F, 0.05F};  // some blades lean toward it
};

// Folded blades of two triangles about the sites, shuffled; normals bent outward from the crown's middle; light through
// the crown counted in a coarse grid of blades.
scene::Leaves make_foliage(const TreeSkeleton& skeleton, const FoliageOptions& options, base::Seed seed);

// One blade of two triangles along an axis; flat side toward face. Four vertices: foot, left, tip, right.
struct BladeShape {
    glm::vec3 site_m{0};
    glm::vec3 along{0, 1, 0};  // unit
    glm::vec3 face{0, 0, 1};   // unit, across along
    float length_m = 0.3F;
    float half_width_m = 0.08F;
    float fold_m = 0.03F;
    float bow_m = 0;  // the tip bends toward face by so much
};
void add_blade(scene::Leaves& leaves, const BladeShape& blade, const scene::Leaves::Vertex& common);

// One triangle from a foot of the blade's width to its tip: grass.
void add_spike(scene::Leaves& leaves, const BladeShape& blade, const scene::Leaves::Vertex& common);

}  // namespace quadrat::synthesis::trees
