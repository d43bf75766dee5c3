// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "base/seed.hpp"
#include "synthesis/trees/skeleton.hpp"

// What a life out of doors does to a tree of any grower.
namespace quadrat::synthesis::trees {

// Limbs fall, of any order but the stems', whose leafy ends get less than this share of the light that the tree's ends
// get in the mean, 0 to 0.9: what stands over them is its own crown. Three in five ends stay whatever is asked. Takes
// and leaves a tree of height 1.
void shed_shaded(TreeSkeleton& skeleton, float least_share);

// Leaves gather where there is light (by -1), or are as many more where the crown shades them (by 1); 0: as they are.
// Takes and leaves a tree of height 1.
void set_leaves_by_light(TreeSkeleton& skeleton, float by);

// A one-sided crown: the wind, a direction times 0 to 1, breaks limbs that stand against it and keeps the rest of them
// short; on the far side they reach farther. The stem stays where it is. In any unit; only from measured skeletons.
void face_wind(TreeSkeleton& skeleton, const glm::vec3& wind, base::Seed seed);

}  // namespace quadrat::synthesis::trees
