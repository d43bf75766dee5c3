// SPDX-License-Identifier: Apache-2.0
#include "render/choose/water_levels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "base/seed.hpp"
#include "scene/camera.hpp"

namespace quadrat::render::choose {
namespace {

constexpr float kCell_m = 0.9F;
constexpr int kColumns = 193;  // three squares a side

// A land that hides no water.
const mesh::Field kLow_m(kColumns, kColumns, -100);

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
    WaterLevels levels(mesh, kLow_m, kCell_m);
    const auto indices = levels.take_indices();
    const double whole_m2 = static_cast<double>(mesh.triangle_count()) / 2 * kCell_m * kCell_m;
    std::size_t before = mesh.indices.size();
    for (std::size_t level = 0; level < WaterLevels::kLevels; ++level) {
        const float nearness = 890 / (WaterLevels::kFrom_m[level] + 1);
        const auto ranges = levels.seen(seen_from(kAbove), kAbove.eye_m, nearness);
        EXPECT_NEAR(area_m2(mesh, indices, ranges), whole_m2, 1e-3 * whole_m2) << level;
        // In the last there is nothing left to merge of so small a lake.
        EXPECT_LT(drawn(ranges), before + (level + 1 == WaterLevels::kLevels ? 1 : 0)) << level;
        before = drawn(ranges);
    }
    EXPECT_LT(before * 8, mesh.indices.size());
}

TEST(WaterLevels, NeighboursOfAnyLevelsMeetWithoutACrack) {
    const mesh::Mesh mesh = lake();
    WaterLevels levels(mesh, kLow_m, kCell_m);
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

// A bowl about the lake: its banks rise from the shore, with ribs that water must not show through.
mesh::Field bowl(const std::function<bool(int, int)>& is_wet) {
    mesh::Field land_m(kColumns, kColumns, 0);
    for (int y = 0; y < kColumns; ++y)
        for (int x = 0; x < kColumns; ++x) {
            const bool is_in_it = is_wet(x, y) && is_wet(x - 1, y) && is_wet(x, y - 1) && is_wet(x - 1, y - 1);
            land_m.at(x, y) = is_in_it ? 1.0F : 3.05F + 0.5F * static_cast<float>((x + 2 * y) % 7);
        }
    return land_m;
}

// What the levels draw, and where: the surface's vertices and the banks'.
struct Shown {
    mesh::Mesh surface;  // with the banks' vertices
    std::vector<std::uint32_t> indices;
    WaterLevels levels;

    Shown(const mesh::Mesh& water, const mesh::Field& land_m) : surface(water), levels(water, land_m, kCell_m) {
        indices = levels.take_indices();
        const auto banks = levels.take_banks();
        EXPECT_LE(banks.size(), WaterLevels::most_banks(water));
        for (const WaterLevels::Bank& bank : banks) {
            surface.positions_m.push_back(bank.at_m);
            EXPECT_LT(bank.like, water.positions_m.size());
        }
    }
    std::vector<Range> from(glm::vec3 eye_m, float nearness) const {
        return levels.seen(seen_from(kAbove), eye_m, nearness);
    }
};

TEST(WaterLevels, CoarseOnesGoOnUnderTheBanksWithFewerTriangles) {
    const mesh::Mesh water = lake();
    const Shown open(water, kLow_m);
    const Shown banked(water, bowl(in_lake));
    for (std::size_t level = 0; level < WaterLevels::kLevels; ++level) {
        const float nearness = 890 / (WaterLevels::kFrom_m[level] + 1);
        const std::size_t open_count = drawn(open.from(kAbove.eye_m, nearness));
        const std::size_t banked_count = drawn(banked.from(kAbove.eye_m, nearness));
        if (level < WaterLevels::kUnderBanksFrom)
            EXPECT_EQ(banked_count, open_count) << level;
        else
            EXPECT_LT(banked_count * 3, open_count * 2) << level;
    }
}

TEST(WaterLevels, NothingIsSeenOfThemBeyondTheWater) {
    const auto is_wet = [](int x, int y) { return in_lake(x, y) || (std::abs(y - 90) < 2 && x > 3 && x < 190); };
    const mesh::Mesh water = surface(is_wet, [](int, int) { return 3.0F; });
    const mesh::Field land_m = bowl(is_wet);
    const Shown shown(water, land_m);
    // A point of the surface either lies over a wet cell or under the land, wherever it is asked.
    for (const float nearness : {0.02F, 0.2F, 1.0F, 3.0F, 9.0F}) {
        for (const Range& range : shown.from({120, 30, -40}, nearness)) {
            for (std::size_t i = range.first; i < range.first + range.count; i += 3) {
                const auto at = [&](std::size_t k) { return shown.surface.positions_m[shown.indices[i + k]]; };
                for (const glm::vec3& share :
                     {glm::vec3{0.34F, 0.33F, 0.33F}, {0.8F, 0.1F, 0.1F}, {0.1F, 0.2F, 0.7F}}) {
                    const glm::vec3 point = at(0) * share.x + at(1) * share.y + at(2) * share.z;
                    const float x = point.x / kCell_m + 0.5F * (kColumns - 1);
                    const float y = point.z / kCell_m + 0.5F * (kColumns - 1);
                    if (is_wet(static_cast<int>(x), static_cast<int>(y))) continue;
                    ASSERT_GE(mesh::sample(land_m, x, y), point.y) << x << ' ' << y << " nearness " << nearness;
                }
            }
        }
    }
}

// An island wider than banks are followed, a ring of water about it; and a moat whose water falls in steps.
TEST(WaterLevels, TakeNoVertexThatIsNotThere) {
    const auto ring = [](int x, int y) { return std::abs(std::max(std::abs(x - 96), std::abs(y - 96)) - 34) < 4; };
    const auto step = [](int x, int y) { return 3.0F + 0.3F * static_cast<float>((x + y) / 24); };
    for (const bool falls : {false, true}) {
        const mesh::Mesh water = surface(ring, [&](int x, int y) { return falls ? step(x, y) : 3.0F; });
        const mesh::Field high_m(kColumns, kColumns, 60);
        const Shown shown(water, high_m);
        for (const std::uint32_t index : shown.indices) ASSERT_LT(index, shown.surface.positions_m.size());
        const auto ranges = shown.from({0, 30, 0}, 0.01F);
        EXPECT_LT(drawn(ranges), water.indices.size());
        for (const Range& range : ranges)
            for (std::size_t i = range.first; i < range.first + range.count; i += 3) {
                const auto at = [&](std::size_t k) { return shown.surface.positions_m[shown.indices[i + k]]; };
                EXPECT_GT(glm::cross(at(1) - at(0), at(2) - at(0)).y, 0);
            }
    }
}

TEST(WaterLevels, BanksLeaveNoCrackInTheWater) {
    const mesh::Mesh water = lake();
    const Shown shown(water, bowl(in_lake));
    base::RandomStream random{base::Seed{9}};
    for (int i = 0; i < 40; ++i) {
        const glm::vec3 eye_m{random.between(-150, 150), random.between(4, 200), random.between(-150, 150)};
        const auto ranges = shown.from(eye_m, random.between(0.05F, 2.0F));
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const Range& range : ranges)
            for (std::size_t k = range.first; k < range.first + range.count; k += 3)
                for (std::size_t e = 0; e < 3; ++e)
                    ++edges[std::minmax(shown.indices[k + e], shown.indices[k + (e + 1) % 3])];
        // Where the surface ends there is no water on one side at least: an edge within it is two triangles'.
        for (const auto& [edge, triangles] : edges) {
            if (triangles != 1) continue;
            const glm::vec3 middle =
                0.5F * (shown.surface.positions_m[edge.first] + shown.surface.positions_m[edge.second]);
            const auto cell = [&](float at_m) {
                return static_cast<int>(std::floor(at_m / kCell_m + 0.5F * (kColumns - 1) + 0.01F));
            };
            const int x = cell(middle.x);
            const int y = cell(middle.z);
            const bool is_within = in_lake(x, y) && in_lake(x - 1, y) && in_lake(x, y - 1) && in_lake(x - 1, y - 1);
            ASSERT_FALSE(is_within) << i << ": " << x << ' ' << y;
        }
    }
}

TEST(WaterLevels, WhatFallsKeepsItsShape) {
    const auto river = [](int x, int y) { return std::abs(y - 90) < 6 && x > 3; };
    const mesh::Mesh steps = surface(river, [](int x, int) { return x / 5 % 2 == 0 ? 1.0F : 2.5F; });
    WaterLevels levels(steps, kLow_m, kCell_m);
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
    WaterLevels levels(mesh, kLow_m, kCell_m);
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
    EXPECT_TRUE(WaterLevels(mesh::Mesh{}, kLow_m, 1).seen(seen_from(kAbove), kAbove.eye_m, 1).empty());
}

}  // namespace
}  // namespace quadrat::render::choose
