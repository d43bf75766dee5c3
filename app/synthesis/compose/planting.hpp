// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "base/seed.hpp"
#include "scene/flora.hpp"
#include "scene/land.hpp"
#include "synthesis/compose/track.hpp"

namespace quadrat::synthesis {

// How many plants a scene may have, and how far around the camera's way its undergrowth stands.
struct PlantingBudget {
    std::size_t trees = 900;
    std::size_t undergrowth = 3600;
    float reach_m = 40;    // of herbs; shrubs stand farther
    float herb_m = 0.62F;  // between herbs where they are dense
};

// Who stands where: by height, slope, moisture and light, in groves with clearings, the old with room around them and
// the young between, no two trunks or roots in one place, none in the water, none in the camera's way, some to frame
// its view, one to look at. The track is that flight over this land; without cameras none of it is asked for. Sorted by
// species; sun is left at 1.
std::vector<scene::Plant> plant_land(const scene::Land& land, const scene::Flora& flora, const FlightPlan& flight,
                                     const scene::Track& track, base::Seed seed, const PlantingBudget& budget = {});

}  // namespace quadrat::synthesis
