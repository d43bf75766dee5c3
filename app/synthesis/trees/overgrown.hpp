// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/flora.hpp"
#include "synthesis/trees/foliage.hpp"

namespace quadrat::synthesis::trees {

// The leaves of a climber that has grown up a trunk, no farther than high_m, of the shape that the tree's own have; no
// more than most blades.
scene::Leaves climber_leaves(const scene::Wood& wood, float trunk_radius_m, float high_m, const LeafShape& shape,
                             std::size_t most, base::Seed seed);

// Spreads blades among others of the same shape, so that a prefix has its share of both.
void mix_in(scene::Leaves& to, const scene::Leaves& others);

}  // namespace quadrat::synthesis::trees
