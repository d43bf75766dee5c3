// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "mesh/image.hpp"

namespace quadrat::synthesis::trees {

enum class Bark { Furrowed, Plates, Smooth, Banded };

// Tileable relief of bark, 0 to 1, side x side samples: columns around the limb, rows along it.
mesh::Field bark_relief(Bark kind, base::Seed seed, int side);

// The picture that scene::Species wants of it: slopes and lightness, deeper by depth 0 to 1.
mesh::Image bark_picture(const mesh::Field& relief, float depth);

// Gray & Scott's reaction (as in Pearson, "Complex patterns in a simple system", 1993) on a torus, its diffusion faster
// along the rows' way by stretch; the concentration of the second substance, 0 to about 0.4.
struct Reaction {
    float feed = 0.050F;
    float kill = 0.0620F;
    float stretch = 6;  // at 3 it closes into rings, at 10 it is all lines
    int steps = 700;
};
mesh::Field react(const Reaction& reaction, base::Seed seed, int side);

}  // namespace quadrat::synthesis::trees
