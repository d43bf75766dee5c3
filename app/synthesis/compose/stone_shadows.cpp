// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/stone_shadows.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

namespace quadrat::synthesis {
namespace {

constexpr int kSub = 4;           // sub-samples along a pixel's side: a boulder is often smaller than a pixel
constexpr float kLongest = 9.0F;  // the longest shadow to its height; a lower sun's are lost in the haze

using Mask = mesh::Grid<std::uint16_t>;  // a bit for each sub-sample that lies in shadow

// Marks the sub-samples within a triangle, given in sub-samples.
void mark(Mask& mask, std::array<glm::vec2, 3> p) {
    const auto cross = [](glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; };
    const float area = cross(p[1] - p[0], p[2] - p[0]);
    if (area == 0) return;
    if (area < 0) std::swap(p[1], p[2]);
    const glm::vec2 low = glm::min(glm::min(p[0], p[1]), p[2]);
    const glm::vec2 high = glm::max(glm::max(p[0], p[1]), p[2]);
    const int x0 = std::max(static_cast<int>(std::ceil(low.x - 0.5F)), 0);
    const int y0 = std::max(static_cast<int>(std::ceil(low.y - 0.5F)), 0);
    const int x1 = std::min(static_cast<int>(std::floor(high.x - 0.5F)), mask.columns * kSub - 1);
    const int y1 = std::min(static_cast<int>(std::floor(high.y - 0.5F)), mask.rows * kSub - 1);
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const glm::vec2 at{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F};
            bool is_within = true;
            for (std::size_t i = 0; i < 3; ++i) is_within = is_within && cross(p[(i + 1) % 3] - p[i], at - p[i]) >= 0;
            if (!is_within) continue;
            mask.at(x / kSub, y / kSub) |= static_cast<std::uint16_t>(1U << (y % kSub * kSub + x % kSub));
        }
    }
}

// Of closed meshes that stand on the land.
mesh::Field cast(const scene::Land& land, const mesh::Mesh& stone, const glm::vec3& to_light, int side) {
    if (stone.indices.empty()) return {};
    const glm::vec2 flat{to_light.x, to_light.z};
    const float run_per_rise = std::min(glm::length(flat) / std::max(to_light.y, 0.02F), kLongest);
    const glm::vec2 away = glm::length(flat) > 1.0e-4F ? -flat / glm::length(flat) : glm::vec2{0};
    // Where each vertex's shadow meets the ground, which may rise or fall on the way. What is sunk in the ground casts
    // it where it stands.
    std::vector<glm::vec2> spots;
    spots.reserve(stone.positions_m.size());
    for (const glm::vec3& from : stone.positions_m) {
        const glm::vec2 foot{from.x, from.z};
        glm::vec2 spot = foot;
        for (int i = 0; i < 8 && run_per_rise > 0; ++i) {
            const float drop_m = std::max(from.y - std::max(scene::ground_height_m(land, spot), 0.0F), 0.0F);
            spot = foot + away * (0.5F * glm::length(spot - foot) + 0.5F * run_per_rise * drop_m);
        }
        spots.push_back(spot);
    }
    Mask mask(side, side, 0);
    const float per_m = static_cast<float>(side * kSub) / land.side_m();
    const float half_m = 0.5F * land.side_m();
    for (std::size_t i = 0; i + 2 < stone.indices.size(); i += 3) {
        std::array<glm::vec2, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = (spots[stone.indices[i + k]] + half_m) * per_m;
        mark(mask, corners);
    }
    mesh::Field hidden(side, side, 0.0F);
    for (std::size_t i = 0; i < hidden.samples.size(); ++i)
        hidden.samples[i] = static_cast<float>(std::popcount(mask.samples[i])) / (kSub * kSub);
    return hidden;
}

}  // namespace

mesh::Field cast_stone(const scene::Land& land, const glm::vec3& to_light, int side) {
    return cast(land, land.stone.mesh, to_light, side);
}

mesh::Field cast_houses(const scene::Land& land, const glm::vec3& to_light, int side) {
    mesh::Mesh all;
    for (const scene::House& house : land.settlement.houses) {
        const mesh::Mesh& one = land.settlement.buildings[house.building].levels.back().mesh;
        const auto first = static_cast<std::uint32_t>(all.positions_m.size());
        for (const glm::vec3& p : one.positions_m) all.positions_m.push_back(scene::placed(house, p));
        for (const std::uint32_t index : one.indices) all.indices.push_back(first + index);
    }
    return cast(land, all, to_light, side);
}

}  // namespace quadrat::synthesis
