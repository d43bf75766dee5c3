// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/scene.hpp"

namespace quadrat::synthesis {

// What the water shows that the flight looks over: the sky with its clouds, and beyond the water's near edge the shore,
// the heights behind it and whatever of the plants stands there, each in the light that it has and the air before it.
// No water ahead: an empty mirror. The scene has its parts, plants, light and track.
scene::Mirror hold_up_mirror(const scene::Scene& scene);

}  // namespace quadrat::synthesis
