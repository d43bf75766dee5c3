// SPDX-License-Identifier: Apache-2.0
#include "kiosk/benches/benches.hpp"
#include "scene/parameters.hpp"
#include "synthesis/grow.hpp"

namespace quadrat::kiosk::benches {

void land(Results& results) {
    over_threads(results, "land.scene_ms", [](const genome::Recipe& r) {
        synthesis::grow_land(scene::realise(r.values).land, r.seeds[genome::Aspect::Land]);
    });
}

}  // namespace quadrat::kiosk::benches
