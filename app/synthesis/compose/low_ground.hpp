// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/camera.hpp"
#include "scene/land.hpp"

namespace quadrat::synthesis {

// The height above the sea of the lowest tenth of the ground that the flight looks over; the sea's, where that is
// deeper. An empty track: 0.
float low_ground_m(const scene::Land& land, const scene::Track& track);

}  // namespace quadrat::synthesis
