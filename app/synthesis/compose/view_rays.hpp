// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "scene/camera.hpp"
#include "scene/land.hpp"

namespace quadrat::synthesis {

inline constexpr int kRayColumns = 13;

// Rays spread evenly over a picture of 16 by 9: unit directions, so many in each row, from left to right.
std::vector<glm::vec3> view_rays(const scene::Camera& camera);

// Where a point stands in that picture, -1 to 1 rightward and up within it; nowhere if it is less than 4 m before the
// eye.
std::optional<glm::vec2> in_picture(const scene::Camera& camera, const glm::vec3& at_m);

inline constexpr float kFarthest_m = 5000;
struct Hit {
    float distance_m;  // kFarthest_m: the sky
    bool is_water;
};

// What a ray from the eye meets first, land or water.
Hit first_hit(const scene::Land& land, const glm::vec3& eye, const glm::vec3& ray);

}  // namespace quadrat::synthesis
