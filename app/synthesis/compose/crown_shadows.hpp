// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "mesh/field.hpp"
#include "scene/flora.hpp"
#include "scene/land.hpp"

namespace quadrat::synthesis {

// What the crowns let through to the ground over the land's square, 0 to 1: of the sun (their shadows, cast along its
// direction onto the ground), and of the sky (right below them).
struct CrownShade {
    mesh::Field sun;
    mesh::Field sky;
};
CrownShade cast_crowns(const scene::Land& land, const glm::vec3& sun_direction, const scene::Flora& flora,
                       std::span<const scene::Plant> plants, int side);

}  // namespace quadrat::synthesis
