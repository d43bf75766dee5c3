// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>
#include <vector>

#include "base/seed.hpp"
#include "mesh/nearness.hpp"
#include "scene/flora.hpp"
#include "synthesis/trees/leaf_shape.hpp"
#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

struct BareCrown {
    float radius_m = 1;
    glm::vec3 bark{0.1F};
    const mesh::Nearness* wood = nullptr;  // what is drawn of its limbs, on which twigs begin; none: where leaves would
};

// The finest twigs of a crown, where its leaves have fallen (Organ::None): as wood they would be too many triangles,
// and the levels for afar would leave them out first. They are slivers of the shape that the tree's leaves have, and
// thin out with distance as leaves do. No more than most; none where nothing has fallen.
scene::Leaves bare_twigs(const TreeSkeleton& skeleton, const BareCrown& crown, const LeafShape& shape, std::size_t most,
                         base::Seed seed);

// All that a tree without any leaves shows beside its wood, as slivers (sliver_shape()): first its limbs, strongest
// first, for from afar its wood leaves them out, and a trunk alone is a stake; near by they lie within that wood. Then
// its twigs. No more than most.
scene::Leaves leafless_crown(const TreeSkeleton& skeleton, const BareCrown& crown, std::size_t most, base::Seed seed);

// The same from so far away that a twig is no pixel wide: strokes along what its limbs are at their ends, which let the
// sky through, as levels of one mass, finest first. None where nothing grows on its limbs.
std::vector<scene::CrownMass> leafless_masses(const TreeSkeleton& skeleton, const BareCrown& crown, base::Seed seed);

}  // namespace quadrat::synthesis::trees
