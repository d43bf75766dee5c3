// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "mesh/field.hpp"

namespace quadrat::synthesis::noise {

// Gray & Scott's reaction (as in Pearson, "Complex patterns in a simple system", 1993) on a torus, its diffusion faster
// along the rows' way by stretch; the concentration of the second substance, 0 to about 0.4.
struct Reaction {
    float feed = 0.050F;
    float kill = 0.0620F;
    float stretch = 6;  // at 3 it closes into rings, at 10 it is all lines
    int steps = 700;
};
mesh::Field react(const Reaction& reaction, base::Seed seed, int side);

}  // namespace quadrat::synthesis::noise
