// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "scene/flora.hpp"
#include "scene/parameters.hpp"

namespace quadrat::synthesis::trees {

// All species of a scene, as grow_trees() promises them: the tree the genes ask for, a slighter relative of it, then
// undergrowth that goes with them.
scene::Flora make_flora(const scene::TreeParameters& parameters, base::Seed seed);

}  // namespace quadrat::synthesis::trees
