// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "scene/flora.hpp"
#include "scene/parameters_fwd.hpp"

namespace quadrat::synthesis::trees {

// All species of a scene, as grow_trees() promises them: one to three trees, a shrub, then herbs. Parameters outside
// the table's ranges are the caller's mistake; inside them every combination is plants within their budgets.
scene::Flora make_flora(const scene::TreeParameters& parameters, base::Seed seed);

}  // namespace quadrat::synthesis::trees
