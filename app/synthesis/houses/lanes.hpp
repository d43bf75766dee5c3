// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "base/seed.hpp"
#include "scene/land.hpp"

namespace quadrat::synthesis::houses {

// A street to build along: points a step apart, outward from the settlement's middle.
struct Lane {
    std::vector<glm::vec2> line_m;
    float width_m = 2.6F;
    bool is_road = false;  // of the land: it is there already
};
inline constexpr float kLaneStep_m = 5;

struct LaneRules {
    float width_m = 2.6F;
    float winding = 0.6F;  // 0 straight to 1
    float longest_m = 90;
};

// Ground that one could build on: dry, over the sea and not at the land's edge.
bool is_buildable(const scene::Land& land, glm::vec2 at_m);
float steepness(const scene::Land& land, glm::vec2 at_m, float over_m = 6);  // rise over run

// Grows a lane from a place in about a direction, bending with the land so that it climbs little (after Parish & Müller
// 2001: global goals propose, local constraints bend and end). Ends at water, steep ground and other lanes.
std::optional<Lane> grow_lane(const scene::Land& land, const std::vector<Lane>& others, glm::vec2 from_m,
                              glm::vec2 toward, const LaneRules& rules, base::Seed seed);

}  // namespace quadrat::synthesis::houses
