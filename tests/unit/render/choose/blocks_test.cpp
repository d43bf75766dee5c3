// SPDX-License-Identifier: Apache-2.0
#include "render/choose/blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/camera.hpp"
#include "unit/render/rugged_ground.hpp"

namespace quadrat::render::choose {
namespace {

using tests::Corner;
using tests::corner;
using tests::kCell_m;
using tests::kSide;
using tests::rugged;

// All of the land at once, however near: from straight above.
Frustum from_above(glm::vec3& eye_m) {
    const scene::Camera camera{{3, 420, 5}, {0, 0, 0}, 60};
    eye_m = camera.eye_m;
    return Frustum(scene::clip_from_view(camera, 1) * scene::view_from_world(camera));
}

TEST(Blocks, CoverTheLandOnceWithUpwardTrianglesAtAnyDetail) {
    const Blocks blocks(rugged(0.02F, 3), kCell_m, 32);
    glm::vec3 eye_m;
    const Frustum frustum = from_above(eye_m);
    for (const float error_px : {0.01F, 0.3F, 1.0F, 4.0F, 60.0F}) {
        std::vector<std::uint32_t> indices;
        const std::size_t triangles = blocks.select(frustum, {eye_m, 469, error_px, 1'000'000}, indices).triangles;
        EXPECT_EQ(3 * triangles, indices.size());
        long twice_area = 0;
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            const Corner a = corner(indices[i]);
            const Corner b = corner(indices[i + 1]);
            const Corner c = corner(indices[i + 2]);
            // Rows run south, so counter-clockwise seen from above is negative here.
            const long twice = -((b.column - a.column) * (c.row - a.row) - (c.column - a.column) * (b.row - a.row));
            EXPECT_GT(twice, 0);
            twice_area += twice;
        }
        EXPECT_EQ(twice_area, 2L * (kSide - 1) * (kSide - 1));
    }
}

TEST(Blocks, LeaveNoCracksWhereLevelsMeet) {
    const Blocks blocks(rugged(0.02F, 3), kCell_m, 16);
    glm::vec3 eye_m;
    const Frustum frustum = from_above(eye_m);
    for (const float error_px : {0.2F, 0.7F, 1.5F, 3.0F}) {
        std::vector<std::uint32_t> indices;
        blocks.select(frustum, {eye_m, 469, error_px, 1'000'000}, indices);
        // In a mesh without cracks every edge is used once each way, but for those on the rim.
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (std::size_t i = 0; i < indices.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k) ++edges[{indices[i + k], indices[i + (k + 1) % 3]}];
        for (const auto& [edge, count] : edges) {
            EXPECT_EQ(count, 1);
            const Corner a = corner(edge.first);
            const Corner b = corner(edge.second);
            const bool is_rim = (a.column == b.column && (a.column == 0 || a.column == kSide - 1)) ||
                                (a.row == b.row && (a.row == 0 || a.row == kSide - 1));
            EXPECT_EQ(edges.contains({edge.second, edge.first}), !is_rim);
        }
    }
}

TEST(Blocks, KeepTheirTriangleBudget) {
    const Blocks blocks(rugged(0.02F, 3), kCell_m, 16);
    glm::vec3 eye_m;
    const Frustum frustum = from_above(eye_m);
    std::size_t before = 0;
    for (const std::size_t budget : {300U, 1'000U, 5'000U, 40'000U}) {
        std::vector<std::uint32_t> indices;
        const std::size_t triangles = blocks.select(frustum, {eye_m, 469, 0.01F, budget}, indices).triangles;
        EXPECT_LE(triangles, budget);
        EXPECT_GE(triangles, before);
        before = triangles;
    }
    EXPECT_GT(before, 5'000U);
}

TEST(Blocks, KnowHowFarEachLevelLiesFromTheGround) {
    const mesh::Field field = rugged(0.02F, 3);
    const Blocks blocks(field, kCell_m, 16);
    for (int level = 1; level <= blocks.coarsest_level(); ++level) {
        for (int block = 0; block < blocks.blocks_a_side() * blocks.blocks_a_side(); ++block) {
            const int c0 = block % blocks.blocks_a_side() * 16;
            const int r0 = block / blocks.blocks_a_side() * 16;
            const int step = 1 << level;
            float worst_m = 0;
            for (int r = 0; r <= 16; ++r) {
                for (int c = 0; c <= 16; ++c) {
                    const int cell_c = std::min(c / step * step, 16 - step);
                    const int cell_r = std::min(r / step * step, 16 - step);
                    const float u = static_cast<float>(c - cell_c) / static_cast<float>(step);
                    const float v = static_cast<float>(r - cell_r) / static_cast<float>(step);
                    const auto height = [&](int i, int k) {
                        return field.at(c0 + cell_c + i * step, r0 + cell_r + k * step);
                    };
                    const float on_surface = u + v <= 1 ? height(0, 0) + u * (height(1, 0) - height(0, 0)) +
                                                              v * (height(0, 1) - height(0, 0))
                                                        : height(1, 1) + (1 - u) * (height(0, 1) - height(1, 1)) +
                                                              (1 - v) * (height(1, 0) - height(1, 1));
                    worst_m = std::max(worst_m, std::abs(on_surface - field.at(c0 + c, r0 + r)));
                }
            }
            // Of a level that lies no farther off than the finer one, more is said: its vertices move later.
            const float least_m = 2 * blocks.error_m(block, level - 1);
            EXPECT_NEAR(std::max(worst_m, least_m), blocks.error_m(block, level), 1e-4F);
        }
    }
}

TEST(Blocks, CountApartWhatBeginsNearer) {
    const Blocks blocks(rugged(0.02F, 3), kCell_m, 16);
    const scene::Camera camera{{0, 20, 120}, {0, 0, 0}, 60};
    const Frustum frustum(scene::clip_from_view(camera, 1) * scene::view_from_world(camera));
    std::vector<std::uint32_t> indices;
    Blocks::Wish wish{camera.eye_m, 469, 0.5F, 1'000'000};
    EXPECT_EQ(blocks.select(frustum, wish, indices).near_indices, 0U);
    wish.near_m = 60;
    indices.clear();
    const Blocks::Selected selected = blocks.select(frustum, wish, indices);
    EXPECT_GT(selected.near_indices, 0U);
    EXPECT_LT(selected.near_indices, indices.size());
    // What is nearer than that is all among them.
    for (std::size_t i = selected.near_indices; i < indices.size(); ++i) {
        const Corner at = corner(indices[i]);
        const float x = (static_cast<float>(at.column) - 64) * kCell_m;
        const float z = (static_cast<float>(at.row) - 64) * kCell_m;
        EXPECT_GE(std::hypot(x, z - 120, 20.0F) + 11, wish.near_m);
    }
}

TEST(Blocks, DrawNothingWhollyInsideTheHole) {
    const Blocks whole(rugged(0.02F, 3), kCell_m, 16);
    const Blocks holed(rugged(0.02F, 3), kCell_m, 16, 64);
    glm::vec3 eye_m;
    const Frustum frustum = from_above(eye_m);
    std::vector<std::uint32_t> all;
    std::vector<std::uint32_t> some;
    const Blocks::Wish finest{eye_m, 469, 0.0001F, 1'000'000};
    const std::size_t everything = whole.select(frustum, finest, all).triangles;
    const std::size_t rest = holed.select(frustum, finest, some).triangles;
    EXPECT_EQ(everything - rest, 2U * 32 * 32);
}

}  // namespace
}  // namespace quadrat::render::choose
