// SPDX-License-Identifier: Apache-2.0
#include "render/passes/water_levels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "base/seed.hpp"
#include "scene/camera.hpp"

namespace quadrat::render::passes {
namespace {

constexpr float kCell_m = 0.9F;
constexpr int kColumns = 193;  // three squares a side

// Two triangles a cell, wherever is_wet; its corners at height_m.
mesh::Mesh surface(const std::function<bool(int, int)>& is_wet, const std::function<float(int, int)>& height_m) {
    mesh::Mesh mesh;
    std::map<std::pair<int, int>, std::uint32_t> corners;
    const auto corner = [&](int x, int y) {
        const auto [found, is_new] = corners.try_emplace({x, y}, static_cast<std::uint32_t>(mesh.positions_m.size()));
        if (is_new) {
            const float half = 0.5F * (kColumns - 1);
            mesh.positions_m.push_back(
                {(static_cast<float>(x) - half) * kCell_m, height_m(x, y), (static_cast<float>(y) - half) * kCell_m});
            mesh.texcoords.emplace_back(0);
        }
        return found->second;
    };
    for (int y = 0; y + 1 < kColumns; ++y) {
        for (int x = 0; x + 1 < kColumns; ++x) {
            if (!is_wet(x, y)) continue;
            const auto a = corner(x, y);
            const auto b = corner(x + 1, y);
            const auto c = corner(x, y + 1);
            const auto d = corner(x + 1, y + 1);
            mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
        }
    }
    return mesh;
}

bool in_lake(int x, int y) { return std::hypot(x - 100, y - 90) < 70 + 12 * std::sin(0.2 * x); }
mesh::Mesh lake() {
    return surface(in_lake, [](int, int) { return 3.0F; });
}

Frustum seen_from(const scene::Camera& camera) {
    return Frustum(scene::clip_from_view(camera, 1.5F) * scene::view_from_world(camera));
}

const scene::Camera kAbove{{0, 900, 1}, {0, 0, 0}, 60};

std::size_t drawn(const std::vector<Range>& ranges) {
    std::size_t count = 0;
    for (const Range& range : ranges) count += range.count;
    return count;
}

// Positive: as it should be.
double area_m2(const mesh::Mesh& mesh, const std::vector<std::uint32_t>& indices, const std::vector<Range>& ranges) {
    double area = 0;
    for (const Range& range : ranges) {
        for (std::size_t i = range.first; i < range.first + range.count; i += 3) {
            const auto at = [&](std::size_t k) { return mesh.positions_m[indices[i + k]]; };
            const glm::vec3 u = at(1) - at(0);
            const glm::vec3 v = at(2) - at(0);
            const double own = 0.5 * (double{u.z} * v.x - double{u.x} * v.z);
            EXPECT_GT(own, 0);
            area += own;
        }
    }
    return area;
}

// Of edges that one triangle alone has: the rim, and every crack twice.
double lone_edges_m(const mesh::Mesh& mesh, const std::vector<std::uint32_t>& indices,
                    const std::vector<Range>& ranges) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const Range& range : ranges)
        for (std::size_t i = range.first; i < range.first + range.count; i += 3)
            for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax(indices[i + k], indices[i + (k + 1) % 3])];
    double length_m = 0;
    for (const auto& [edge, triangles] : edges)
        if (triangles == 1) length_m += glm::distance(mesh.positions_m[edge.first], mesh.positions_m[edge.second]);
    return length_m;
}

TEST(WaterLevels, EveryLevelCoversTheSameWaterWithFewerTriangles) {
    const mesh::Mesh mesh = lake();
    WaterLevels levels(mesh, kCell_m, kColumns);
    const auto indices = levels.take_indices();
    const double whole_m2 = static_cast<double>(mesh.triangle_count()) / 2 * kCell_m * kCell_m;
    std::size_t before = mesh.indices.size();
    for (std::size_t level = 0; level < WaterLevels::kLevels; ++level) {
        const float nearness = 890 / (WaterLevels::kFrom_m[level] + 1);
        const auto ranges = levels.seen(seen_from(kAbove), kAbove.eye_m, nearness);
        EXPECT_NEAR(area_m2(mesh, indices, ranges), whole_m2, 1e-3 * whole_m2) << level;
        EXPECT_LT(drawn(ranges), before) << level;
        before = drawn(ranges);
    }
    EXPECT_LT(before * 8, mesh.indices.size());
}

TEST(WaterLevels, NeighboursOfAnyLevelsMeetWithoutACrack) {
    const mesh::Mesh mesh = lake();
    WaterLevels levels(mesh, kCell_m, kColumns);
    const auto indices = levels.take_indices();
    const double rim_m = lone_edges_m(mesh, mesh.indices, {{0, mesh.indices.size()}});
    base::RandomStream random{base::Seed{8}};
    for (int i = 0; i < 40; ++i) {
        // From one side squares are of different levels.
        const glm::vec3 eye_m{random.between(-150, 150), random.between(4, 200), random.between(-150, 150)};
        const auto ranges = levels.seen(seen_from(kAbove), eye_m, random.between(0.2F, 2.0F));
        EXPECT_NEAR(lone_edges_m(mesh, indices, ranges), rim_m, 1e-4 * rim_m) << i;
    }
}

TEST(WaterLevels, WhatFallsKeepsItsShape) {
    const auto river = [](int x, int y) { return std::abs(y - 90) < 6 && x > 3; };
    const mesh::Mesh steps = surface(river, [](int x, int) { return x / 5 % 2 == 0 ? 1.0F : 2.5F; });
    WaterLevels levels(steps, kCell_m, kColumns);
    const auto indices = levels.take_indices();
    const auto far = levels.seen(seen_from(kAbove), {0, 2000, 0}, 1);
    // Every step is still there: as high in the far level as in the near one.
    float low = 9;
    float high = -9;
    for (const Range& range : far)
        for (std::size_t i = range.first; i < range.first + range.count; ++i) {
            low = std::min(low, steps.positions_m[indices[i]].y);
            high = std::max(high, steps.positions_m[indices[i]].y);
        }
    EXPECT_EQ(low, 1.0F);
    EXPECT_EQ(high, 2.5F);
    EXPECT_GT(drawn(far) * 4, steps.indices.size());
}

TEST(WaterLevels, LeaveOutNothingThatIsSeenAndMostOfWhatIsNot) {
    const mesh::Mesh mesh = surface([](int, int) { return true; }, [](int, int) { return 0.0F; });
    WaterLevels levels(mesh, kCell_m, kColumns);
    const auto indices = levels.take_indices();
    const std::size_t all = drawn(levels.seen(seen_from(kAbove), {0, 8, 0}, 1));
    for (int turn = 0; turn < 8; ++turn) {
        const float way = 0.785F * static_cast<float>(turn);
        const scene::Camera camera{{0, 8, 0}, {std::sin(way), 8, -std::cos(way)}, 45};
        const Frustum frustum = seen_from(camera);
        const auto ranges = levels.seen(frustum, camera.eye_m, 1);
        EXPECT_GT(drawn(ranges), 0U);
        EXPECT_LT(drawn(ranges), all);
        // Whatever of the surface lies in view lies in a square that is drawn.
        double seen_m2 = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            if (frustum.may_see_sphere(mesh.positions_m[mesh.indices[i]], 0)) seen_m2 += 0.5 * kCell_m * kCell_m;
        EXPECT_GE(area_m2(mesh, indices, ranges), seen_m2);
    }
}

TEST(WaterLevels, OfNothingShowNothing) {
    EXPECT_TRUE(WaterLevels{}.seen(seen_from(kAbove), kAbove.eye_m, 1).empty());
    EXPECT_TRUE(WaterLevels(mesh::Mesh{}, 1, 65).seen(seen_from(kAbove), kAbove.eye_m, 1).empty());
}

}  // namespace
}  // namespace quadrat::render::passes
