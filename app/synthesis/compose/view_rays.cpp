// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/view_rays.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace quadrat::synthesis {
namespace {

constexpr int kRows = 9;
constexpr float kAspect = 16.0F / 9;

struct Axes {
    glm::vec3 ahead, right, up;
    float half_up;  // of the picture, at a distance of 1
};

Axes axes_of(const scene::Camera& camera) {
    Axes axes{};
    axes.ahead = glm::normalize(camera.target_m - camera.eye_m);
    axes.right = glm::normalize(glm::cross(axes.ahead, glm::vec3{0, 1, 0}));
    axes.up = glm::cross(axes.right, axes.ahead);
    axes.half_up = std::tan(glm::radians(camera.vertical_fov_deg) / 2);
    return axes;
}

}  // namespace

std::optional<glm::vec2> in_picture(const scene::Camera& camera, const glm::vec3& at_m) {
    constexpr float kBefore_m = 4;
    const Axes axes = axes_of(camera);
    const glm::vec3 to = at_m - camera.eye_m;
    const float depth_m = glm::dot(to, axes.ahead);
    if (depth_m < kBefore_m) return std::nullopt;
    return glm::vec2{glm::dot(to, axes.right) / kAspect, glm::dot(to, axes.up)} / (depth_m * axes.half_up);
}

std::vector<glm::vec3> view_rays(const scene::Camera& camera) {
    const auto [ahead, right, up, half_up] = axes_of(camera);
    std::vector<glm::vec3> rays;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kRayColumns; ++column) {
            const float x = (2 * static_cast<float>(column) + 1) / kRayColumns - 1;
            const float y = 1 - (2 * static_cast<float>(row) + 1) / kRows;
            rays.push_back(glm::normalize(ahead + half_up * (kAspect * x * right + y * up)));
        }
    }
    return rays;
}

// Steps grow with the distance: a hill that is missed between two of them is too small to matter.
Hit first_hit(const scene::Land& land, const glm::vec3& eye, const glm::vec3& ray) {
    for (float d = 4; d < kFarthest_m; d *= 1.19F) {
        const glm::vec3 at = eye + d * ray;
        if (ray.y > 0 && at.y > 900) break;
        const float ground_m = scene::ground_height_m(land, {at.x, at.z});
        const float depth_m = scene::water_depth_m(land, {at.x, at.z});
        if (at.y <= std::max(ground_m, 0.0F) + (ground_m > 0 ? depth_m : 0.0F)) return {d, depth_m > 0 || ground_m < 0};
    }
    return {kFarthest_m, false};
}

}  // namespace quadrat::synthesis
