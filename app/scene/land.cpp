// SPDX-License-Identifier: Apache-2.0
#include "scene/land.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace quadrat::scene {
namespace {

template <typename Number>
float sample_at(const mesh::Grid<Number>& field, float cell_m, glm::vec2 at_m) {
    const float half_columns = 0.5F * static_cast<float>(field.columns - 1);
    const float half_rows = 0.5F * static_cast<float>(field.rows - 1);
    return mesh::sample(field, at_m.x / cell_m + half_columns, at_m.y / cell_m + half_rows);
}

constexpr float kKeptClearSteps = 8;  // a metre

}  // namespace

float ground_height_m(const Land& land, glm::vec2 at_m) {
    const float half_side = 0.5F * land.side_m();
    const bool is_on_land = std::abs(at_m.x) <= half_side && std::abs(at_m.y) <= half_side;
    if (is_on_land || land.surround_m.samples.empty()) return sample_at(land.height_m, land.cell_m, at_m);
    return sample_at(land.surround_m, land.surround_cell_m, at_m);
}

float water_surface_m(const Land& land, glm::vec2 at_m) {
    const mesh::Field& water = land.water_m;
    const float half_side = 0.5F * land.side_m();
    if (water.samples.empty() || std::abs(at_m.x) > half_side || std::abs(at_m.y) > half_side) return 0;
    const float half = 0.5F * static_cast<float>(water.columns - 1);
    const int column = static_cast<int>(std::lround(at_m.x / land.cell_m + half));
    const int row = static_cast<int>(std::lround(at_m.y / land.cell_m + half));
    return water.is_inside(column, row) ? std::max(0.0F, water.at(column, row)) : 0.0F;
}

float water_depth_m(const Land& land, glm::vec2 at_m) {
    return std::max(water_surface_m(land, at_m) - ground_height_m(land, at_m), 0.0F);
}

mesh::Grid<std::uint8_t> kept_clear_of(const mesh::Field& to_edge_m) {
    mesh::Grid<std::uint8_t> kept_clear(to_edge_m.columns, to_edge_m.rows);
    std::ranges::transform(to_edge_m.samples, kept_clear.samples.begin(), [](float away_m) {
        const float short_by = std::ceil((kFarFromRoads_m - away_m) * kKeptClearSteps);
        return static_cast<std::uint8_t>(255 - std::clamp(short_by, 0.0F, 255.0F));
    });
    return kept_clear;
}

float to_road_m(const Land& land, glm::vec2 at_m) {
    if (land.kept_clear.samples.empty()) return kFarFromRoads_m;
    return kFarFromRoads_m - (255 - sample_at(land.kept_clear, land.cell_m, at_m)) / kKeptClearSteps;
}

glm::vec3 ground_normal(const Land& land, glm::vec2 at_m) {
    const float half = 0.5F * land.cell_m;
    const float dx = ground_height_m(land, {at_m.x + half, at_m.y}) - ground_height_m(land, {at_m.x - half, at_m.y});
    const float dz = ground_height_m(land, {at_m.x, at_m.y + half}) - ground_height_m(land, {at_m.x, at_m.y - half});
    return glm::normalize(glm::vec3{-dx, land.cell_m, -dz});
}

}  // namespace quadrat::scene
