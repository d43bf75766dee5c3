// SPDX-License-Identifier: Apache-2.0
#include "kiosk/benches/benches.hpp"
#include "scene/parameters.hpp"
#include "synthesis/grow.hpp"

namespace quadrat::kiosk::benches {

void trees(Results& results) {
    over_threads(results, "trees.scene_ms", [](const genome::Recipe& r) {
        synthesis::grow_trees(scene::realise(r.values).trees, r.seeds[genome::Aspect::Trees]);
    });
}

}  // namespace quadrat::kiosk::benches
