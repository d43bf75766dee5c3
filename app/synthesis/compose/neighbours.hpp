// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "scene/flora.hpp"
#include "synthesis/compose/competition.hpp"

namespace quadrat::synthesis {

// Gives each tree the form that its neighbours made it grow, where its kind has several: in a closed stand tall and
// bare below, at an edge to the open side, which is turned away from them, elsewhere round. Trees of mark 0 were set
// for the picture's sake and stay as they are.
void grow_among_neighbours(std::vector<Candidate>& trees, const scene::Flora& flora);

}  // namespace quadrat::synthesis
