// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "base/seed.hpp"

namespace quadrat::mesh {

// Value noise in space, -1 to 1: a number for each point of the unit lattice, between which it goes smoothly.
float value_noise(const glm::vec3& at, base::Seed seed);

}  // namespace quadrat::mesh
