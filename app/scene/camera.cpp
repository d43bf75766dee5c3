// SPDX-License-Identifier: Apache-2.0
#include "scene/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace quadrat::scene {
namespace {

constexpr float kNear_m = 0.5F;
constexpr float kFar_m = 12000.0F;

template <typename T>
T catmull_rom(const T& a, const T& b, const T& c, const T& d, float t) {
    return 0.5F *
           (2.0F * b + t * ((c - a) + t * ((2.0F * a - 5.0F * b + 4.0F * c - d) + t * (3.0F * (b - c) + d - a))));
}

}  // namespace

Camera camera_at(const Track& track, float seconds) {
    if (track.cameras.empty()) return {};
    const int last = static_cast<int>(track.cameras.size()) - 1;
    if (last == 0 || !(track.period_s > 0)) return track.cameras.front();
    // There and back on half a cosine: at rest at both ends.
    const float turn = std::fmod(seconds / track.period_s, 1.0F);
    const float share = 0.5F - 0.5F * std::cos(turn * 2.0F * 3.14159265F);
    const float at = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(last);
    const int i = std::min(static_cast<int>(at), last - 1);
    const float t = at - static_cast<float>(i);
    const auto camera = [&](int k) -> const Camera& { return track.cameras[std::clamp(k, 0, last)]; };
    const Camera& a = camera(i - 1);
    const Camera& b = camera(i);
    const Camera& c = camera(i + 1);
    const Camera& d = camera(i + 2);
    return {catmull_rom(a.eye_m, b.eye_m, c.eye_m, d.eye_m, t),
            catmull_rom(a.target_m, b.target_m, c.target_m, d.target_m, t),
            catmull_rom(a.vertical_fov_deg, b.vertical_fov_deg, c.vertical_fov_deg, d.vertical_fov_deg, t)};
}

glm::mat4 view_from_world(const Camera& camera) {
    return glm::lookAt(camera.eye_m, camera.target_m, glm::vec3{0, 1, 0});
}

glm::mat4 clip_from_view(const Camera& camera, float aspect_ratio) {
    return glm::perspective(glm::radians(camera.vertical_fov_deg), aspect_ratio, kNear_m, kFar_m);
}

}  // namespace quadrat::scene
