// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "scene/parameters_fwd.hpp"
#include "scene/sky.hpp"

namespace quadrat::synthesis::sky {

// The whole sky, as grow_sky() promises it.
scene::Sky make_sky(const scene::SkyParameters& parameters, base::Seed seed);

}  // namespace quadrat::synthesis::sky
