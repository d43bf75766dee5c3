// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/low_ground.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

namespace quadrat::synthesis {
namespace {

// From where a view begins to show ground to where mist has hidden it.
constexpr float kNearest_m = 15;
constexpr float kFarthest_m = 320;
constexpr float kGrowth = 1.25F;  // from one place to the next
constexpr std::size_t kCameras = 12;
constexpr std::size_t kTenth = 10;

void look_over(const scene::Land& land, const scene::Camera& camera, std::vector<float>& heights_m) {
    const glm::vec2 eye_m{camera.eye_m.x, camera.eye_m.z};
    const glm::vec2 way = glm::vec2{camera.target_m.x, camera.target_m.z} - eye_m;
    const glm::vec2 ahead = way / std::max(glm::length(way), 1e-3F);
    const glm::vec2 aside{-ahead.y, ahead.x};
    for (float away_m = kNearest_m; away_m < kFarthest_m; away_m *= kGrowth)
        for (const float turn : {-0.45F, -0.15F, 0.15F, 0.45F})
            heights_m.push_back(scene::ground_height_m(land, eye_m + away_m * (ahead + turn * aside)));
}

}  // namespace

float low_ground_m(const scene::Land& land, const scene::Track& track) {
    std::vector<float> heights_m;
    const std::size_t step = std::max<std::size_t>(track.cameras.size() / kCameras, 1);
    for (std::size_t i = 0; i < track.cameras.size(); i += step) look_over(land, track.cameras[i], heights_m);
    if (heights_m.empty()) return 0;
    const auto low = heights_m.begin() + static_cast<std::ptrdiff_t>(heights_m.size() / kTenth);
    std::ranges::nth_element(heights_m, low);
    return std::max(*low, 0.0F);
}

}  // namespace quadrat::synthesis
