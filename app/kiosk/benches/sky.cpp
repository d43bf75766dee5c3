// SPDX-License-Identifier: Apache-2.0
#include "kiosk/benches/benches.hpp"
#include "scene/parameters.hpp"
#include "synthesis/grow.hpp"

namespace quadrat::kiosk::benches {

void sky(Results& results) {
    over_threads(results, "sky.scene_ms", [](const genome::Recipe& r) {
        synthesis::grow_sky(scene::realise(r.values).sky, r.seeds[genome::Aspect::Sky]);
    });
}

}  // namespace quadrat::kiosk::benches
