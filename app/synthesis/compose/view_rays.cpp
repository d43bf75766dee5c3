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
    float half_up;
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

Picture::Picture(const scene::Camera& camera) : eye_m_(camera.eye_m) {
    const Axes axes = axes_of(camera);
    ahead_ = axes.ahead;
    right_ = axes.right;
    up_ = axes.up;
    half_up_ = axes.half_up;
}

std::optional<glm::vec2> Picture::at(const glm::vec3& at_m) const {
    constexpr float kBefore_m = 4;
    const glm::vec3 to = at_m - eye_m_;
    const float depth_m = glm::dot(to, ahead_);
    if (depth_m < kBefore_m) return std::nullopt;
    return glm::vec2{glm::dot(to, right_) / kAspect, glm::dot(to, up_)} / (depth_m * half_up_);
}

std::optional<glm::vec2> in_picture(const scene::Camera& camera, const glm::vec3& at_m) {
    return Picture(camera).at(at_m);
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

float ceiling_over_m(const scene::Land& land) {
    constexpr float kRounding_m = 1;  // between samples, and much more
    float most = 0;
    for (const mesh::Field* field : {&land.height_m, &land.surround_m, &land.water_m})
        if (!field->samples.empty()) most = std::max(most, std::ranges::max(field->samples));
    return std::min(most + kRounding_m, Within{}.ceiling_m);
}

// Steps grow with the distance: a hill that is missed between two of them is too small to matter.
Hit first_hit(const scene::Land& land, const glm::vec3& eye, const glm::vec3& ray, const Within& within) {
    for (float d = 4; d < within.farthest_m; d *= 1.19F) {
        const glm::vec3 at = eye + d * ray;
        if (ray.y > 0 && at.y > within.ceiling_m) break;
        const float ground_m = scene::ground_height_m(land, {at.x, at.z});
        if (ground_m <= 0 && at.y > 0) continue;
        const float depth_m = std::max(scene::water_surface_m(land, {at.x, at.z}) - ground_m, 0.0F);
        if (at.y <= std::max(ground_m, 0.0F) + (ground_m > 0 ? depth_m : 0.0F)) return {d, depth_m > 0 || ground_m < 0};
    }
    return {kFarthest_m, false};
}

}  // namespace quadrat::synthesis
