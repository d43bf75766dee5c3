// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/flora.hpp"
#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

struct LimbDetail {
    int trunk_sides = 8;
    int limb_sides = 6;        // of the first order; two fewer for each further one, 3 at least
    int last_generation = 99;  // limbs of later generations are left out
    int node_stride = 1;       // every so many nodes of a limb become a ring, and the last
};

// Limbs as tapered cylinders with conical ends, each closed by itself, all in one mesh; the trunk spreads at its foot.
scene::Wood mesh_limbs(const TreeSkeleton& skeleton, const LimbDetail& detail);

}  // namespace quadrat::synthesis::trees
