// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "base/seed.hpp"
#include "scene/flora.hpp"
#include "scene/land.hpp"
#include "synthesis/compose/track.hpp"

namespace quadrat::synthesis {

inline constexpr std::size_t kMostTrees = 900;
inline constexpr std::size_t kMostUndergrowth = 3600;

// Who stands where: by height, slope and water, in groves with clearings, no two trunks or roots in one place, none in
// the water, none in the camera's way, some to frame its view. Sorted by species; sun is left at 1.
std::vector<scene::Plant> plant_land(const scene::Land& land, const scene::Flora& flora, const FlightPlan& flight,
                                     base::Seed seed);

}  // namespace quadrat::synthesis
