// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "scene/colour.hpp"

namespace quadrat::scene {

// What the season makes of the ground's own colour (linear), as a factor: what is green turns to straw of its
// lightness; rock, sand and snow stay as they are. withered: Cover's.
inline glm::vec3 withering_of(const glm::vec3& albedo, float withered) {
    constexpr glm::vec3 kStraw{1.38F, 1.04F, 0.62F};  // to its lightness; dead grass is a little lighter
    const glm::vec3 own = glm::max(albedo, glm::vec3{0.004F});
    // Grass, olive too, has more green than sand has, and less blue than grey stone.
    const float green = std::clamp((own.g - 0.85F * own.r) / (0.3F * own.g), 0.0F, 1.0F) *
                        std::clamp((own.g - own.b) / (0.4F * own.g), 0.0F, 1.0F);
    const glm::vec3 straw = luminance(own) * kStraw / own;
    return glm::mix(glm::vec3{1}, glm::clamp(straw, glm::vec3{0.4F}, glm::vec3{8}), withered * green);
}

}  // namespace quadrat::scene
