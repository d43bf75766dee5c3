// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/scene.hpp"

namespace quadrat::synthesis {

// How far a camera stops down for what it sees on the flight: 1, or less where snow, sand or fog in full light would
// leave a picture that is nearly white. The sky's own exposure (daylight) does not know the land. A factor of light.
float stopped_down(const scene::Land& land, const scene::Sky& sky, const scene::BakedLight& light,
                   const scene::Track& track);

}  // namespace quadrat::synthesis
