// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/view_merit.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace quadrat::synthesis {
namespace {

constexpr int kColumns = 13;
constexpr int kRows = 9;
constexpr float kFarthest_m = 5000;

struct Hit {
    float distance_m;  // kFarthest_m: the sky
    bool is_water;
};

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

}  // namespace

Outlook outlook(const scene::Land& land, const scene::Camera& camera) {
    const glm::vec3 ahead = glm::normalize(camera.target_m - camera.eye_m);
    const glm::vec3 right = glm::normalize(glm::cross(ahead, glm::vec3{0, 1, 0}));
    const glm::vec3 up = glm::cross(right, ahead);
    const float half_up = std::tan(glm::radians(camera.vertical_fov_deg) / 2);
    Outlook seen;
    constexpr float kShare = 1.0F / (kColumns * kRows);
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const float x = (2 * static_cast<float>(column) + 1) / kColumns - 1;
            const float y = 1 - (2 * static_cast<float>(row) + 1) / kRows;
            const Hit hit = first_hit(land, camera.eye_m,
                                      glm::normalize(ahead + half_up * (16.0F / 9 * x * right + y * up)));
            if (hit.distance_m >= kFarthest_m)
                seen.sky += kShare;
            else if (hit.is_water)
                seen.water += kShare;
            else if (hit.distance_m < 45)
                seen.near += kShare;
            else if (hit.distance_m > 500)
                seen.far += kShare;
            if (!hit.is_water && hit.distance_m < 12) seen.walled += kShare;
        }
    }
    return seen;
}

float view_merit(const Outlook& seen) {
    const auto up_to = [](float share, float enough) { return std::min(share / enough, 1.0F); };
    const float off_sky = (seen.sky - 0.36F) / 0.25F;
    const float too_much = std::max(seen.near - 0.42F, 0.0F) + std::max(seen.water - 0.45F, 0.0F);
    return up_to(seen.near, 0.16F) + 0.9F * up_to(seen.far, 0.10F) + 0.8F * up_to(seen.water, 0.10F) -
           0.8F * off_sky * off_sky - 3 * too_much - 4 * std::max(seen.walled - 0.10F, 0.0F);
}

}  // namespace quadrat::synthesis
