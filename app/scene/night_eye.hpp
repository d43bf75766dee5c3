// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace quadrat::scene {

// How much of a colour an eye sees by night, 1 by day: in little light its rods see, which tell light from dark alone.
// At nightfall it is still nearly all. darkness: Sky's, 0 to 1.
inline float colour_seen(float darkness) { return 1 - 0.68F * darkness * darkness; }

// A surface's colour (linear) as it is seen then: greyer, and what is red is darker, for rods are blind to it (CIE 1951
// scotopic luminosity, over the three primaries). shaders/common/night_eye.glsl is the same.
inline glm::vec3 seen_by_night(const glm::vec3& albedo, float colour_seen) {
    constexpr glm::vec3 kRods{0.06F, 0.60F, 0.34F};
    return glm::mix(glm::vec3{glm::dot(albedo, kRods)}, albedo, colour_seen);
}

}  // namespace quadrat::scene
