// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/near_things.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace quadrat::synthesis {
namespace {

constexpr float kRockNear_m = 55;
constexpr float kRockTooNear_m = 1;
constexpr float kHousesNear_m = 32;

// Level axes of a house and its height.
glm::vec3 upright(glm::vec2 level, float up) { return {level.x, up, level.y}; }

}  // namespace

StandingRock::StandingRock(const scene::Land& land) {
    constexpr float kBuried_m = 0.3F;
    for (const glm::vec3& p : land.stone.mesh.positions_m)
        if (!(p.y < scene::ground_height_m(land, {p.x, p.z}) + kBuried_m)) corners_m_.push_back(p);
    std::ranges::sort(corners_m_, {}, &glm::vec3::x);
}

std::span<const glm::vec3> StandingRock::between(float west_m, float east_m) const {
    const auto first = std::ranges::lower_bound(corners_m_, west_m, {}, &glm::vec3::x);
    return {first, std::ranges::upper_bound(first, corners_m_.end(), east_m, {}, &glm::vec3::x)};
}

NearRock::NearRock(const StandingRock& rock, const glm::vec3& eye_m) {
    constexpr float kReach_m = kRockNear_m + 1;  // and what rounding takes
    for (const glm::vec3& p : rock.between(eye_m.x - kReach_m, eye_m.x + kReach_m)) {
        const glm::vec2 off_m{p.x - eye_m.x, p.z - eye_m.z};
        const float away_m = glm::length(off_m);
        if (away_m > kRockNear_m || away_m < kRockTooNear_m) continue;
        Side& side = sides_[side_of(off_m)];
        side.rise = std::max(side.rise, (p.y - eye_m.y) / away_m);
        side.nearest_m = std::min(side.nearest_m, away_m);
    }
}

bool NearRock::stands_before(const glm::vec3& ray, float land_m) const {
    const float level = std::hypot(ray.x, ray.z);
    const Side& side = sides_[side_of({ray.x, ray.z})];
    return ray.y < side.rise * level && side.nearest_m < land_m * level;
}

std::size_t NearRock::side_of(const glm::vec2& to) {
    const float turns = std::atan2(to.x, -to.y) / glm::two_pi<float>() + 1;
    return static_cast<std::size_t>(turns * kSides) % kSides;
}

NearHouses::NearHouses(const scene::Settlement& settlement, const glm::vec3& eye_m) {
    constexpr float kBelowRidge = 0.85F;  // a roof is narrower than its walls
    for (const scene::House& house : settlement.houses) {
        if (glm::length(house.foot_m - eye_m) > 1.5F * kHousesNear_m) continue;
        const scene::Building& building = settlement.buildings[house.building];
        const scene::HouseFrame frame(building, house);
        boxes_.push_back({frame, upright(frame.in_house_m({eye_m.x, eye_m.z}), eye_m.y - house.foot_m.y),
                          upright(building.half_m, kBelowRidge * building.height_m)});
    }
}

bool NearHouses::stand_before(const glm::vec3& ray, float land_m) const {
    return std::ranges::any_of(boxes_, [&](const Box& box) {
        const glm::vec3 along = upright(box.frame.in_house({ray.x, ray.z}), ray.y);
        const glm::vec3 low = (glm::vec3{-box.size_m.x, 0, -box.size_m.z} - box.eye_m) / along;
        const glm::vec3 high = (box.size_m - box.eye_m) / along;
        const glm::vec3 in = glm::min(low, high);
        const glm::vec3 out = glm::max(low, high);
        const float enters_m = std::max({in.x, in.y, in.z, 0.0F});
        return enters_m < std::min({out.x, out.y, out.z}) && enters_m < std::min(kHousesNear_m, land_m);
    });
}

}  // namespace quadrat::synthesis
