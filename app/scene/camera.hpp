// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace quadrat::scene {

struct Camera {
    glm::vec3 eye_m{0, 2, 0};
    glm::vec3 target_m{0, 2, -10};
    float vertical_fov_deg = 42;
};

// A slow flight over one scene: cameras at even steps of time over one period; it glides there and back, never jumps.
struct Track {
    std::vector<Camera> cameras;  // at least one
    float period_s = 80;          // from the first to the last and back again
};

Camera camera_at(const Track& track, float seconds);  // any time, smooth; an empty track gives Camera{}

glm::mat4 view_from_world(const Camera& camera);
glm::mat4 clip_from_view(const Camera& camera, float aspect_ratio);  // near 0.5 m, far 12 km, depth -1 to 1

}  // namespace quadrat::scene
