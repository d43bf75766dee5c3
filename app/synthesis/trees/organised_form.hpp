// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "synthesis/trees/form.hpp"
#include "synthesis/trees/self_organising.hpp"

namespace quadrat::synthesis::trees {

// What the genes make of a kind's way of growing; kind(form.habit) is of Grower::SelfOrganised.
SelfOrganisation organisation_of(const Form& form);

// A tree of height 1 that stands alone: all its stems grow in one another's shade.
TreeSkeleton grow_organised(const Form& form, base::Seed seed);

// Of 5 by 5 that grow together, the one in the middle and one at the edge, which is open toward +x; each of height 1.
struct StandOfTwo {
    TreeSkeleton middle, edge;
};
StandOfTwo grow_organised_stand(const Form& form, base::Seed seed);

}  // namespace quadrat::synthesis::trees
