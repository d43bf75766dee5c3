// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <optional>

#include "scene/land.hpp"
#include "scene/parameters_fwd.hpp"

namespace quadrat::synthesis::houses {

// Where people would have settled: level, dry, sunny, near water, sheltered or on a height as they like it, by the road
// where there is one, and in sight. The land's site where it keeps one. None where nothing is fit.
std::optional<glm::vec2> settling_place(const scene::Land& land, const scene::LandParameters& parameters);

// How far the nearest water is, up to a distance.
float to_water_m(const scene::Land& land, glm::vec2 at_m, float most_m = 160);

}  // namespace quadrat::synthesis::houses
