// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "base/seed.hpp"
#include "scene/flora.hpp"
#include "synthesis/trees/leaf_shape.hpp"
#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

// The finest twigs of a crown, where its leaves have fallen (Organ::None): as wood they would be too many triangles,
// and the levels for afar would leave them out first. They are slivers of the shape that the tree's leaves have, and
// thin out with distance as leaves do. No more than most; none where nothing has fallen.
scene::Leaves bare_twigs(const TreeSkeleton& skeleton, float crown_radius_m, const glm::vec3& bark,
                         const LeafShape& shape, std::size_t most, base::Seed seed);

}  // namespace quadrat::synthesis::trees
