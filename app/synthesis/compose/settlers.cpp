// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/settlers.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "synthesis/houses/bounds.hpp"
#include "synthesis/houses/grounds.hpp"
#include "synthesis/houses/waterside.hpp"

namespace quadrat::synthesis {
namespace {

constexpr float kLaneGrade = 0.25F;
constexpr float kAboutWalls_m = 3.0F;  // kept clear of plants

}  // namespace

void HouseBuilders::build(scene::Land& land) {
    settled_ = houses::settle(land, parameters_, seed_);
    if (settled_.settlement.is_empty()) return;
    houses::level_ground(land, settled_);
    for (const houses::Lane& lane : settled_.lanes) {
        scene::Road road{{}, lane.width_m, kLaneGrade};
        for (const glm::vec2 p : lane.line_m) road.line_m.emplace_back(p.x, scene::ground_height_m(land, p), p.y);
        land.roads.push_back(std::move(road));
    }
    land.settlement = settled_.settlement;
    fields_ = houses::lay_fields(land, settled_, parameters_, seed_.child("fields"));
    land.settlement.bounds = houses::add_bounds(land, settled_, fields_, parameters_, seed_.child("bounds"));
    for (scene::Masses& jetty : houses::add_jetties(land, settled_, parameters_, seed_.child("jetties")))
        land.settlement.bounds.push_back(std::move(jetty));
}

void HouseBuilders::keep_clear(const scene::Land& land, mesh::Field& to_edge_m) {
    if (to_edge_m.samples.empty())
        to_edge_m = mesh::Field(land.height_m.columns, land.height_m.rows, scene::kFarFromRoads_m);
    const float half = 0.5F * static_cast<float>(to_edge_m.columns - 1);
    for (const scene::House& house : land.settlement.houses) {
        const scene::Building& building = land.settlement.buildings[house.building];
        const float reach_m = glm::length(building.half_m) + scene::kFarFromRoads_m;
        const auto column = [&](float m) {
            return std::clamp(static_cast<int>(std::lround(m / land.cell_m + half)), 0, to_edge_m.columns - 1);
        };
        for (int y = column(house.foot_m.z - reach_m); y <= column(house.foot_m.z + reach_m); ++y)
            for (int x = column(house.foot_m.x - reach_m); x <= column(house.foot_m.x + reach_m); ++x) {
                const glm::vec2 at = land.cell_m * (glm::vec2{static_cast<float>(x), static_cast<float>(y)} - half);
                float& to_edge = to_edge_m.at(x, y);
                to_edge = std::min(to_edge, scene::to_house_m(building, house, at) - kAboutWalls_m);
            }
    }
    keep_fields_clear(land, to_edge_m);
}

void HouseBuilders::keep_fields_clear(const scene::Land& land, mesh::Field& to_edge_m) const {
    constexpr float kHedge_m = 2;  // left to trees at a field's edge
    const float half = 0.5F * static_cast<float>(to_edge_m.columns - 1);
    for (const houses::FieldPlot& field : fields_) {
        glm::vec2 low = field.outline_m.front();
        glm::vec2 high = low;
        for (const glm::vec2 p : field.outline_m) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        const auto column = [&](float m) {
            return std::clamp(static_cast<int>(std::lround(m / land.cell_m + half)), 0, to_edge_m.columns - 1);
        };
        for (int y = column(low.y); y <= column(high.y); ++y)
            for (int x = column(low.x); x <= column(high.x); ++x) {
                const glm::vec2 at = land.cell_m * (glm::vec2{static_cast<float>(x), static_cast<float>(y)} - half);
                float& to_edge = to_edge_m.at(x, y);
                to_edge = std::min(to_edge, std::max(kHedge_m - houses::within_m(field.outline_m, at), -4.0F));
            }
    }
}

// From the south, where the land opens to the viewer, and from so far that it fills much of a picture.
scene::Landmark HouseBuilders::landmark() const {
    constexpr glm::vec2 kViewer_m{0, 290};
    constexpr float kOverGround_m = 7;
    glm::vec3 middle{0};
    const std::vector<scene::House>& all = settled_.settlement.houses;
    for (const scene::House& house : all) middle += house.foot_m / static_cast<float>(all.size());
    const glm::vec2 south = kViewer_m - glm::vec2{middle.x, middle.z};
    const glm::vec2 faces = glm::length(south) > 1 ? glm::normalize(south) : glm::vec2{0, 1};
    const float size_m = std::clamp(0.6F * settled_.reach_m, 13.0F, 36.0F);
    return {middle + glm::vec3{0, kOverGround_m, 0}, faces, size_m, false};
}

void HouseBuilders::paint(const scene::Land& land, mesh::Image& albedo) {
    houses::paint_grounds(albedo, land, settled_, fields_, parameters_.settle_gardens, seed_.child("grounds"));
}

}  // namespace quadrat::synthesis
