// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/scene.hpp"

namespace quadrat::synthesis {

// How a camera is exposed for what it sees on the flight, as a factor of light: less than 1 where snow, sand or fog in
// full light would leave a picture that is nearly white; more than 1 where nothing in it would be lit, by night or
// under a storm; else 1. The sky's own exposure (daylight) does not know the land.
float exposure_for(const scene::Land& land, const scene::Sky& sky, const scene::BakedLight& light,
                   const scene::Track& track);

// From the darkest twentieth of what the flight sees to the lightest, shown, 0 to 1, as rays into the land tell: plants
// are not among it. A scene without ground or light: 1.
float value_range(const scene::Land& land, const scene::Sky& sky, const scene::BakedLight& light,
                  const scene::Track& track);

}  // namespace quadrat::synthesis
