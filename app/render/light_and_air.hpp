// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace quadrat::render {

// Of a scene's light and air, what every view of it starts from: linear and undimmed.
struct LightAndAir {
    scene::Sky sky;  // without its images, its table and its stars
    glm::vec3 shallow_water{0}, deep_water{0}, high_sky{0}, foam{0};
    float exposure = 1;
    float floor_m = 0;
    float side_m = 1;
    float grain_tile_m = 1;
    float snow_line_m = 1.0e6F;  // plants above it have snow on them
    float houses_sun = 1;
    float withered = 0;  // of what is green of the ground, 0 to 1
    float lamps = 0;     // the share of windows that are lit
};

LightAndAir light_and_air_of(const scene::Scene& scene);

}  // namespace quadrat::render
