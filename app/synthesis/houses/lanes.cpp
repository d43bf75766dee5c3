// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/lanes.hpp"

#include <algorithm>
#include <cmath>

namespace quadrat::synthesis::houses {
namespace {

constexpr float kOverSea_m = 1.3F;
constexpr float kEdge_m = 60;  // to the land's edge

}  // namespace

bool is_buildable(const scene::Land& land, glm::vec2 at_m) {
    if (std::max(std::abs(at_m.x), std::abs(at_m.y)) > 0.5F * land.side_m() - kEdge_m) return false;
    return scene::ground_height_m(land, at_m) > kOverSea_m && scene::water_depth_m(land, at_m) <= 0;
}

float steepness(const scene::Land& land, glm::vec2 at_m, float over_m) {
    const float dx = scene::ground_height_m(land, {at_m.x + over_m, at_m.y}) -
                     scene::ground_height_m(land, {at_m.x - over_m, at_m.y});
    const float dz = scene::ground_height_m(land, {at_m.x, at_m.y + over_m}) -
                     scene::ground_height_m(land, {at_m.x, at_m.y - over_m});
    return std::hypot(dx, dz) / (2 * over_m);
}

}  // namespace quadrat::synthesis::houses
