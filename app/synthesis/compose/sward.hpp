// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "scene/flora.hpp"
#include "scene/land.hpp"
#include "scene/scene.hpp"
#include "scene/sward.hpp"
#include "synthesis/compose/track.hpp"

namespace quadrat::synthesis {

// Covers the ground about the camera's flight: grass, cushions and flowers where its material bears them, stones where
// it does not; nothing in the water and on roads. Deterministic, place by place. Its light is left at 0.
scene::Sward lay_sward(const scene::Land& land, const scene::Flora& flora, const FlightPlan& flight, base::Seed seed);

// Each tuft sends what the ground under it does, so that it melts into it. colour_seen: as of scene::colour_seen.
void light_sward(scene::Sward& sward, const scene::Land& land, const scene::Cover& cover,
                 const scene::BakedLight& light, float colour_seen);

}  // namespace quadrat::synthesis
