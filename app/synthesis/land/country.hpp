// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "scene/land.hpp"
#include "scene/parameters.hpp"
#include "scene/scene.hpp"

namespace quadrat::synthesis::land {

// The whole land, as grow_land() promises it.
scene::Land make_land(const scene::LandParameters& parameters, base::Seed seed, const scene::Fineness& fineness);

}  // namespace quadrat::synthesis::land
