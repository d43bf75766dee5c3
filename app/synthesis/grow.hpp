// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "base/seed.hpp"
#include "scene/parameters.hpp"
#include "scene/scene.hpp"

// The growers. Each is a pure function of its arguments, bit for bit, on any number of threads, and may be called from
// any thread. They run on the caller's oneTBB arena.
namespace quadrat::synthesis {

scene::Flora grow_trees(const scene::TreeParameters& parameters, base::Seed seed);
scene::Land grow_land(const scene::LandParameters& parameters, base::Seed seed, const scene::Fineness& fineness = {});
scene::Sky grow_sky(const scene::SkyParameters& parameters, base::Seed seed);

// Planting, baked light and the camera's track. flight names the path over the land, the same for the four scenes of
// a round; the height follows each land.
scene::Scene compose(std::shared_ptr<const scene::Flora> flora, std::shared_ptr<const scene::Land> land,
                     std::shared_ptr<const scene::Sky> sky, base::Seed planting, base::Seed flight,
                     const scene::Fineness& fineness = {});

}  // namespace quadrat::synthesis
