// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace quadrat::synthesis::houses {
namespace {

constexpr float kOverSea_m = 1.3F;
constexpr float kEdge_m = 60;       // to the land's edge
constexpr float kSteepest = 0.24F;  // of a lane
constexpr float kApart_m = 15;      // from other lanes, but where it begins
constexpr float kShortest_m = 20;

glm::vec2 rotated(glm::vec2 d, float rad) {
    const float c = std::cos(rad);
    const float s = std::sin(rad);
    return {c * d.x - s * d.y, s * d.x + c * d.y};
}

float to_lanes_m(const std::vector<Lane>& lanes, glm::vec2 at) {
    float least = 1.0e9F;
    for (const Lane& lane : lanes)
        for (const glm::vec2 p : lane.line_m) least = std::min(least, glm::distance(p, at));
    return least;
}

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

std::optional<Lane> grow_lane(const scene::Land& land, const std::vector<Lane>& others, glm::vec2 from_m,
                              glm::vec2 toward, const LaneRules& rules, base::Seed seed) {
    base::RandomStream random{seed};
    Lane lane{{from_m}, rules.width_m, false};
    glm::vec2 heading = glm::normalize(toward);
    const glm::vec2 goal = heading;
    float drift = 0;
    const int steps = static_cast<int>(rules.longest_m / kLaneStep_m);
    for (int i = 0; i < steps; ++i) {
        drift = 0.8F * drift + 0.11F * rules.winding * random.normal();
        float least = 1.0e9F;
        glm::vec2 best{0};
        const float here_m = scene::ground_height_m(land, lane.line_m.back());
        for (int k = -3; k <= 3; ++k) {
            const float turn = 0.12F * static_cast<float>(k);
            const glm::vec2 way = rotated(heading, turn);
            const glm::vec2 to = lane.line_m.back() + kLaneStep_m * way;
            const float climb = std::abs(scene::ground_height_m(land, to) - here_m) / kLaneStep_m;
            const glm::vec2 next = to + 2 * kLaneStep_m * way;
            if (climb > kSteepest || !is_buildable(land, to) || !is_buildable(land, next)) continue;
            const float price =
                (1 + 3 * rules.winding) * climb + 0.5F * std::abs(turn - drift) + 0.35F * (1 - glm::dot(way, goal));
            if (price >= least) continue;
            least = price;
            best = way;
        }
        if (least >= 1.0e9F) break;
        const glm::vec2 to = lane.line_m.back() + kLaneStep_m * best;
        if (i >= 3 && to_lanes_m(others, to) < kApart_m) break;
        lane.line_m.push_back(to);
        heading = best;
    }
    if (static_cast<float>(lane.line_m.size() - 1) * kLaneStep_m < kShortest_m) return std::nullopt;
    return lane;
}

}  // namespace quadrat::synthesis::houses
