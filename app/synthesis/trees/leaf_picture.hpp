// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "mesh/image.hpp"
#include "synthesis/trees/leaf_shape.hpp"

namespace quadrat::synthesis::trees {

// How a blade's veins run: from the midrib to the rim, from the foot like fingers, or side by side to the tip.
enum class Venation { Pinnate, Palmate, Parallel };
Venation venation(LeafKind kind);

// The picture that scene::Species wants of its leaves' upper side: veins, the net between them, and the paler or darker
// patches of a living leaf.
mesh::Image leaf_picture(LeafKind kind, base::Seed seed);

// The picture that scene::Species wants of its foliage: leaves of this kind over and over one another, each as light as
// it happens to lie, and the dark between them.
mesh::Image foliage_picture(LeafKind kind, base::Seed seed);

}  // namespace quadrat::synthesis::trees
