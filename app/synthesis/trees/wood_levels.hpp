// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "scene/flora.hpp"
#include "synthesis/trees/skeleton.hpp"

namespace quadrat::synthesis::trees {

// Levels of a tree's wood, finest first, from what its grower knows: which limbs are strongest, and how their rings
// follow one another. Of a tree with leaves the last is a spindle of four triangles, which is what is seen of a stem
// behind far leaves. bareness: 0 in leaf to 1 bare, when twigs are all the crown that there is and more are kept.
std::vector<scene::Wood> wood_levels(const TreeSkeleton& skeleton, float bareness = 0);
// The diameter of the thickest limb that is not among the strongest, of so many nodes; 0: all of them are.
float thickest_left_out_m(const TreeSkeleton& skeleton, std::size_t most_nodes);
void add_spindle(std::vector<scene::Wood>& levels, float height_m, float radius_m);
// And of one that bears all its leaves at its top, which may lean over: a column of eight, as thick as it is up there.
void add_column(std::vector<scene::Wood>& levels, const Limb& trunk);

// Where each vertex of a level goes as the next takes its place: the nearest point of that, or where its neighbours go
// if that is elsewhere, so that limbs which are left out draw back into those that bear them.
void set_coarser(std::vector<scene::Wood>& levels, float trunk_radius_m);

}  // namespace quadrat::synthesis::trees
