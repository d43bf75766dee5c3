// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "mesh/field.hpp"
#include "scene/land.hpp"

namespace quadrat::synthesis {

// The share of each pixel over the land's square, 0 to 1, that the land's stone hides from a light in this direction
// (unit, upward). side: of the field, in pixels. Empty where there is no stone.
mesh::Field cast_stone(const scene::Land& land, const glm::vec3& to_light, int side);

// The same of its houses.
mesh::Field cast_houses(const scene::Land& land, const glm::vec3& to_light, int side);

}  // namespace quadrat::synthesis
