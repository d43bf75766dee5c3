// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "scene/flora.hpp"

namespace quadrat::synthesis::trees {

inline constexpr float kDenseCrown = 0.36F;  // leaf area in a cell of a crown, in areas of the cell's side
inline constexpr float kThinCrown = 0.115F;  // of what is seen from above and close to the ground, which hides more

// The crown these leaves make, from afar: the surface within which they are so dense, as a progressive mesh of some
// hundred triangles and coarser ones. In a dense crown they hide about two thirds of what lies behind. None where the
// crown is nowhere so dense.
std::vector<scene::CrownMass> crown_masses(const scene::Leaves& leaves, float dense = kDenseCrown);

}  // namespace quadrat::synthesis::trees
