// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "scene/flora.hpp"

namespace quadrat::synthesis::trees {

// The crown these leaves make, from afar: the surface within which they hide about two thirds of what lies behind, as a
// progressive mesh of some hundred triangles and coarser ones. None where the crown is nowhere so dense.
std::vector<scene::CrownMass> crown_masses(const scene::Leaves& leaves);

}  // namespace quadrat::synthesis::trees
