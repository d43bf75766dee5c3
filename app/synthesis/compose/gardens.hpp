// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "base/seed.hpp"
#include "scene/flora.hpp"
#include "scene/land.hpp"
#include "scene/parameters_fwd.hpp"
#include "synthesis/compose/competition.hpp"
#include "synthesis/compose/site.hpp"

namespace quadrat::synthesis {

// What people plant by their houses, the oldest houses first: an orchard in rows or rows of vegetables behind, a round
// bed before the wall whose flowers stand as florets do in a head. On dry land, off walls and lanes. Few where
// settle.gardens is low.
std::vector<scene::GardenPlant> lay_gardens(const scene::Land& land, const scene::LandParameters& parameters,
                                            base::Seed seed);

// The kind of a flora's that is nearest to what is asked for; none: flora.species.size().
std::size_t kind_for(const scene::Flora& flora, scene::Bedded what);

// What stands in gardens, as the flora has it: what it lacks is left out, and what nobody on the camera's way sees.
struct Gardened {
    std::vector<Candidate> trees, shrubs, herbs;
};
struct GardenBudget {
    std::size_t trees = 150;
    std::size_t undergrowth = 700;
};
Gardened gardens_in_sight(const scene::Land& land, const scene::Flora& flora, const Sight& sight,
                          const GardenBudget& budget);

// Adds what is planted; what grows wild nearer to it than that makes way, but for what is set for the picture.
inline constexpr float kOrchardRoom_m = 4;
inline constexpr float kBedRoom_m = 0.5F;
void make_way(std::vector<Candidate>& wild, const std::vector<Candidate>& planted, float room_m);

}  // namespace quadrat::synthesis
