// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace quadrat::render {

// Of a scene's light and air, what every view of it starts from: linear and undimmed.
struct LightAndAir {
    glm::vec3 to_sun{0, 1, 0};
    glm::vec3 sunlight{1}, light_above{0}, light_around{0}, light_below{0};
    glm::vec3 far_colour{0}, haze_colour{0}, haze_sunward{0};
    glm::vec3 shallow_water{0}, deep_water{0}, high_sky{0}, foam{0}, sun_colour{1};
    float haze_distance_m = 1000;
    float haze_height_m = 500;
    float side_m = 1;
    float grain_tile_m = 1;
    std::array<scene::CloudLayer, 2> clouds;  // without their images
};

LightAndAir light_and_air_of(const scene::Scene& scene);

}  // namespace quadrat::render
