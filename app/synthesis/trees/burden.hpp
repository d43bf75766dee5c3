// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

// What a node of a limb holds up: all beyond it.
struct Burden {
    float weight = 0;   // of wood by its volume, and of leaves, which weigh as much as a quarter of all wood
    float lever_m = 0;  // from the node to the side, to where that weight hangs
};

// A row a limb, a number a node. Radii are taken as they are.
std::vector<std::vector<Burden>> burdens_of(const TreeSkeleton& skeleton);

// The stress in a limb's skin there, M / r³, to the mean of where limbs leave their stems; 1 where a tree has none.
std::vector<std::vector<float>> stresses_of(const TreeSkeleton& skeleton);

}  // namespace quadrat::synthesis::trees
