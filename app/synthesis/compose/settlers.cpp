// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/settlers.hpp"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>

#include "scene/land_parameters.hpp"
#include "synthesis/compose/gardens.hpp"
#include "synthesis/houses/bounds.hpp"
#include "synthesis/houses/bridges.hpp"
#include "synthesis/houses/fields.hpp"
#include "synthesis/houses/grounds.hpp"
#include "synthesis/houses/waterside.hpp"

namespace quadrat::synthesis {
namespace {

constexpr float kLaneGrade = 0.25F;
constexpr float kAboutWalls_m = 3.0F;  // kept clear of plants

// visit(sample, place) of those within a window of places.
template <typename Visit>
void for_samples(mesh::Field& field, float cell_m, glm::vec2 low_m, glm::vec2 high_m, const Visit& visit) {
    const float half = 0.5F * static_cast<float>(field.columns - 1);
    const auto column = [&](float m) {
        return std::clamp(static_cast<int>(std::lround(m / cell_m + half)), 0, field.columns - 1);
    };
    for (int y = column(low_m.y); y <= column(high_m.y); ++y)
        for (int x = column(low_m.x); x <= column(high_m.x); ++x)
            visit(field.at(x, y), cell_m * (glm::vec2{static_cast<float>(x), static_cast<float>(y)} - half));
}

void keep_fields_clear(const scene::Land& land, mesh::Field& to_edge_m) {
    constexpr float kHedge_m = 2;  // left to trees at a field's edge
    for (const scene::FieldPlot& field : land.settlement.fields) {
        const auto [low, high] = houses::extent_of(field.outline_m);
        const houses::Inside inside(field.outline_m);
        for_samples(to_edge_m, land.cell_m, low, high, [&](float& to_edge, glm::vec2 at) {
            to_edge = std::min(to_edge, std::max(kHedge_m - inside.by_m(at), -4.0F));
        });
    }
}

}  // namespace

void HouseBuilders::build(scene::Land& land) {
    settled_ = houses::settle(land, parameters_, seed_);
    if (settled_.settlement.is_empty()) return;
    houses::level_ground(land, settled_);
    for (const houses::Lane& lane : settled_.lanes) {
        scene::Road road{{}, lane.width_m, kLaneGrade, true};
        for (const glm::vec2 p : lane.line_m) road.line_m.emplace_back(p.x, scene::ground_height_m(land, p), p.y);
        land.roads.push_back(std::move(road));
    }
    land.settlement = std::move(settled_.settlement);
    settled_.settlement = land.settlement.without_masses();
    std::vector<scene::FieldPlot> fields;
    std::vector<scene::GardenPlant> gardens;
    std::vector<scene::Masses> bounds, waterside;
    // Neither knows of the other.
    oneapi::tbb::parallel_invoke(
        [&] {
            fields = houses::lay_fields(land, settled_, parameters_, seed_.child("fields"));
            bounds = houses::add_bounds(land, settled_, fields, parameters_, seed_.child("bounds"));
        },
        [&] {
            gardens = lay_gardens(land, parameters_, seed_.child("gardens"));
            waterside = houses::add_jetties(land, settled_, parameters_, seed_.child("jetties"));
            std::ranges::move(houses::add_bridges(land, settled_, parameters_), std::back_inserter(waterside));
        });
    land.settlement.fields = std::move(fields);
    land.settlement.gardens = std::move(gardens);
    land.settlement.bounds = std::move(bounds);
    std::ranges::move(waterside, std::back_inserter(land.settlement.bounds));
}

void HouseBuilders::keep_clear(const scene::Land& land, mesh::Field& to_edge_m) {
    if (to_edge_m.samples.empty())
        to_edge_m = mesh::Field(land.height_m.columns, land.height_m.rows, scene::kFarFromRoads_m);
    const auto lower = [&](glm::vec2 low_m, glm::vec2 high_m, const auto& away_m) {
        for_samples(to_edge_m, land.cell_m, low_m - scene::kFarFromRoads_m, high_m + scene::kFarFromRoads_m,
                    [&](float& to_edge, glm::vec2 at) { to_edge = std::min(to_edge, away_m(at)); });
    };
    for (const scene::House& house : land.settlement.houses) {
        const scene::Building& building = land.settlement.buildings[house.building];
        const glm::vec2 foot{house.foot_m.x, house.foot_m.z};
        const float reach_m = glm::length(building.half_m);
        const scene::HouseFrame frame(building, house);
        lower(foot - reach_m, foot + reach_m, [&](glm::vec2 at) { return frame.away_m(at) - kAboutWalls_m; });
    }
    for (const houses::Lane& lane : settled_.lanes)
        for (std::size_t i = 0; i + 1 < lane.line_m.size(); ++i) {
            const glm::vec2 from = lane.line_m[i];
            const glm::vec2 d = lane.line_m[i + 1] - from;
            lower(glm::min(from, from + d), glm::max(from, from + d), [&](glm::vec2 at) {
                const float t = std::clamp(glm::dot(at - from, d) / glm::dot(d, d), 0.0F, 1.0F);
                return glm::distance(at, from + t * d) - 0.5F * lane.width_m;
            });
        }
    keep_fields_clear(land, to_edge_m);
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
    houses::paint_grounds(albedo, land, settled_, land.settlement.fields, parameters_.settle_gardens,
                          seed_.child("grounds"));
}

}  // namespace quadrat::synthesis
