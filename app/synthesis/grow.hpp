// SPDX-License-Identifier: Apache-2.0
// The room `synthesis`: grows land, trees, houses and sky, and composes a scene of them. Nothing here knows of genes,
// visits or a GPU, or depends on time and the number of threads.
#pragma once
#include <memory>

#include "base/seed.hpp"
#include "scene/parameters_fwd.hpp"
#include "scene/scene.hpp"
#include "synthesis/compose/openness.hpp"

// The growers. Each is a pure function of its arguments, bit for bit, on any number of threads, and may be called from
// any thread. They run on the caller's oneTBB arena.
namespace quadrat::synthesis {

scene::Flora grow_trees(const scene::TreeParameters& parameters, base::Seed seed);
scene::Land grow_land(const scene::LandParameters& parameters, base::Seed seed, const scene::Fineness& fineness = {});
scene::Sky grow_sky(const scene::SkyParameters& parameters, base::Seed seed);

// What no sky is needed for: where plants stand and where the camera goes.
struct Layout {
    scene::Track track;
    std::vector<scene::Plant> plants;  // sun is left at 1
    scene::Sward sward;                // its light is left at 0
    Openness openness;
};
// flight names the path over the land, the same for the four scenes of a round; the height follows each land.
Layout lay_out(const scene::Flora& flora, const scene::Land& land, base::Seed planting, base::Seed flight);

// Bakes this sky's light on what is laid out of this flora and land.
scene::Scene illuminate(std::shared_ptr<const scene::Flora> flora, std::shared_ptr<const scene::Land> land,
                        std::shared_ptr<const scene::Sky> sky, Layout layout, const scene::Fineness& fineness = {});

// Both.
scene::Scene compose(std::shared_ptr<const scene::Flora> flora, std::shared_ptr<const scene::Land> land,
                     std::shared_ptr<const scene::Sky> sky, base::Seed planting, base::Seed flight,
                     const scene::Fineness& fineness = {});

}  // namespace quadrat::synthesis
