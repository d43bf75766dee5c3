// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/flora.hpp"
#include "synthesis/trees/form.hpp"

namespace quadrat::synthesis::trees {

// The most that a species may have, whatever its genes: each parameter's range is chosen so that they hold.
inline constexpr std::size_t kMostLimbs = 4000;
inline constexpr std::size_t kMostLeafTriangles = 13200;
inline constexpr std::size_t kMostWoodTriangles =
    11000;  // of the finest level; the whole species: 16 MB less than half

// A finished tree: skeleton, smooth limbs, levels of detail, leaves and bark.
scene::Species make_species(const Form& form, base::Seed seed);
// The same as it grows among its like; only of forms that grow in stands.
struct StandSpecies {
    scene::Species middle, edge;
};
StandSpecies make_stand_species(const Form& form, base::Seed seed);
// How far from its finest wood any leaf of such a tree may stand, m.
float farthest_leaf_m(float height_m);
TreeSkeleton skeleton_of_species(const Form& form, base::Seed seed);  // that it is made of

// What the index-th tree of a flora of this seed is made from.
base::Seed seed_of_species(base::Seed flora, std::size_t index);

}  // namespace quadrat::synthesis::trees
