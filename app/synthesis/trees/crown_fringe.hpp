// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "scene/flora.hpp"

namespace quadrat::synthesis::trees {

// Adds sprays that stand off these masses, which are levels of one crown, finest first: a triangle each, as many as the
// mass itself has, so that its outline is ragged and its surface is leaves and not clay. The fewer a level has, the
// larger they are; each knows where it goes before the next level takes its place. Levels of fewer sprays are added
// where the next has far fewer triangles. Levels of few triangles have none, nor those that leave out clumps of the
// crown, nor the balls that follow them, from farther away than sprays show.
void add_fringe(std::vector<scene::CrownMass>& masses);

}  // namespace quadrat::synthesis::trees
