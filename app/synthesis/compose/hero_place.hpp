// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>

#include "base/seed.hpp"
#include "scene/camera.hpp"
#include "scene/land.hpp"
#include "synthesis/compose/track.hpp"

namespace quadrat::synthesis {

// Where a tree stands that is so high, for the eye to come to rest on it as a flight begins: on a third of the picture
// (side -1: the left one, 1: the right one), half as high as that. It stands farther where the picture that the flight
// shows then would cut off its foot or its top, and nowhere if that helps nowhere; a track without cameras is not
// asked.
std::optional<glm::vec2> hero_place(const scene::Land& land, const FlightPlan& flight, const scene::Track& track,
                                    float high_m, float side, base::RandomStream& random);

}  // namespace quadrat::synthesis
