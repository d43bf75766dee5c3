// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/phyllotaxis.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace quadrat::synthesis::trees {

glm::vec2 floret(int n, float c) {
    const float angle = kGoldenAngle_rad * static_cast<float>(n);
    const float r = c * std::sqrt(static_cast<float>(n));
    return {r * std::cos(angle), r * std::sin(angle)};
}

glm::vec3 scale_on_cone(int n, int count, glm::vec3& outward) {
    // A sphere drawn out: bands of the same height have the same area (Archimedes).
    const float up = (static_cast<float>(n) + 0.5F) / static_cast<float>(std::max(count, 1));
    const float y = 2 * up - 1;
    const float r = std::sqrt(std::max(1 - y * y, 0.0F));
    const float angle = kGoldenAngle_rad * static_cast<float>(n);
    outward = glm::normalize(glm::vec3{r * std::cos(angle), 0.6F * y, r * std::sin(angle)} + glm::vec3{0, 1.0e-3F, 0});
    return {r * std::cos(angle), up, r * std::sin(angle)};
}

}  // namespace quadrat::synthesis::trees
