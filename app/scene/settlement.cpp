// SPDX-License-Identifier: Apache-2.0
#include "scene/settlement.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace quadrat::scene {

std::size_t Settlement::triangles() const {
    std::size_t sum = 0;
    for (const Masses& piece : bounds) sum += piece.mesh.triangle_count();
    for (const House& house : houses) sum += buildings[house.building].levels.front().mesh.triangle_count();
    return sum;
}

glm::vec3 turned(const House& house, const glm::vec3& direction) {
    const float c = std::cos(house.yaw_rad);
    const float s = std::sin(house.yaw_rad);
    return {c * direction.x + s * direction.z, direction.y, c * direction.z - s * direction.x};
}

glm::vec3 placed(const House& house, const glm::vec3& in_building_m) {
    return house.foot_m + turned(house, in_building_m);
}

std::vector<glm::vec2> outline_m(const Building& building, const House& house, float grown_m) {
    const glm::vec2 half = building.half_m + grown_m;
    std::vector<glm::vec2> corners;
    for (const glm::vec2 sign : {glm::vec2{-1, 1}, glm::vec2{1, 1}, glm::vec2{1, -1}, glm::vec2{-1, -1}}) {
        const glm::vec3 p = placed(house, {sign.x * half.x, 0, sign.y * half.y});
        corners.emplace_back(p.x, p.z);
    }
    return corners;
}

std::vector<glm::vec2> along_outline_m(const Building& building, const House& house, float grown_m, float apart_m) {
    const std::vector<glm::vec2> corners = outline_m(building, house, grown_m);
    std::vector<glm::vec2> places;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::vec2 from = corners[i];
        const glm::vec2 way = corners[(i + 1) % corners.size()] - from;
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(way) / apart_m)));
        for (int k = 0; k < steps; ++k)
            places.push_back(from + way * (static_cast<float>(k) / static_cast<float>(steps)));
    }
    return places;
}

HouseFrame::HouseFrame(const Building& building, const House& house)
    : foot_m_(house.foot_m.x, house.foot_m.z),
      half_m_(building.half_m),
      cos_(std::cos(house.yaw_rad)),
      sin_(std::sin(house.yaw_rad)) {}

float HouseFrame::away_m(glm::vec2 at_m) const {
    return glm::length(glm::max(glm::abs(in_house_m(at_m)) - half_m_, glm::vec2{0}));
}

float to_house_m(const Building& building, const House& house, glm::vec2 at_m) {
    return HouseFrame(building, house).away_m(at_m);
}

Settlement Settlement::without_masses() const {
    Settlement bare;
    for (const Building& building : buildings)
        bare.buildings.push_back({{}, building.half_m, building.height_m, building.chimneys_m});
    bare.houses = houses;
    bare.lit_share = lit_share;
    return bare;
}

}  // namespace quadrat::scene
