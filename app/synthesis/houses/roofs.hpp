// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "synthesis/houses/building.hpp"

// Not for use from outside.
namespace quadrat::synthesis::houses {

// How high the roof stands over the eaves where its two sides meet over so wide a house.
double rise_m(const Design& design, double width_m);
// How far its upper side lies above the walls' upper edges, on which its lower side rests.
double over_walls_m(const Design& design);
// Of a half hip: how much of a gable the hip takes.
double hip_cut_m(const Design& design, double width_m);

// The outline of the wall under a gable, from the right eave over the top to the left one, both left out; from the left
// eave, metres.
std::vector<glm::dvec2> gable_of(const Design& design, double width_m);

// Covers the plan at each level: the roof's faces, barge and fascia boards, and soffits where it is near. Returns the
// height of the ridge. Throws mesh::PlanError for a plan that is none.
double add_roof(scene::Building& to, const Design& design);

}  // namespace quadrat::synthesis::houses
