// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec3.hpp>

#include "base/seed.hpp"
#include "scene/flora.hpp"

namespace quadrat::synthesis::trees {

// Small plants of a few blades, 6 to 60 triangles each: cheap enough for thousands. Colours linear.
scene::Species grass_tuft(const glm::vec3& colour, float height_m, base::Seed seed);
scene::Species fern(const glm::vec3& colour, float height_m, base::Seed seed);
scene::Species flower(const glm::vec3& leaf, const glm::vec3& blossom, float height_m, base::Seed seed);
scene::Species bush(const glm::vec3& leaf, const glm::vec3& second, const glm::vec3& bark, float height_m,
                    base::Seed seed);

}  // namespace quadrat::synthesis::trees
