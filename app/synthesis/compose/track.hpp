// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <vector>

#include "base/seed.hpp"
#include "scene/camera.hpp"
#include "scene/land.hpp"

namespace quadrat::synthesis {

class Lookout;

// A flight in the horizontal plane: where the camera is and which way it looks. The same for every land.
struct FlightPlan {
    struct Station {
        glm::vec2 at_m;   // x, z
        glm::vec2 ahead;  // unit
    };
    std::vector<Station> stations;
};

// The best of some paths that this seed draws: it begins on the land's southern side, looks across the middle toward
// the north, and moves rather past things than into them.
FlightPlan plan_flight(base::Seed flight);

// The same path over this land, moved by at most some eighty metres to where more is to be seen: ground near by, not
// water alone. It looks and turns as before, so that the four of a round stay comparable; only where a cave, an arch, a
// ring of stones or a road that leads into it makes the better picture it is turned and moved to look at that.
FlightPlan fitted_to(const Lookout& lookout, FlightPlan plan);

// The flight at heights that suit this land: never lower than 1.7 m over ground or 2.5 m over water, high enough to see
// over the nearest rise, and pitched so that the far heights stand in the picture; of some heights and pitches those
// that show the most of what a painter would look for (view_merit.hpp).
scene::Track fly(const FlightPlan& plan, const Lookout& lookout, base::Seed flight);

}  // namespace quadrat::synthesis
