// SPDX-License-Identifier: Apache-2.0
// What a moving camera sees of the squares' levels changing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "render/choose/blocks.hpp"
#include "scene/camera.hpp"
#include "unit/render/rugged_ground.hpp"

namespace quadrat::render::choose {
namespace {

using tests::Corner;
using tests::corner;
using tests::kCell_m;
using tests::kSide;
using tests::rugged;

// The drawn surface's height at every sample that is seen, with its vertices eased as shaders/common/grid.glsl does.
std::vector<float> drawn_heights(const Blocks& blocks, const mesh::Field& field, const Frustum& frustum,
                                 const Blocks::Wish& wish, bool is_eased) {
    std::vector<std::uint32_t> indices;
    Blocks::Wish chosen = wish;
    chosen.error_px = blocks.select(frustum, wish, indices).error_px;
    const auto place = [&](std::uint32_t index) {
        const Corner at = corner(index);
        return glm::vec3{(static_cast<float>(at.column) - 64) * kCell_m, field.at(at.column, at.row),
                         (static_cast<float>(at.row) - 64) * kCell_m};
    };
    const auto height = [&](std::uint32_t index) {
        const Corner at = corner(index);
        const Blocks::Leaving leaving = blocks.leaving(field, at.column, at.row);
        const float t = is_eased ? Blocks::eased(glm::length(place(index) - wish.eye_m), leaving.error_m, chosen) : 0;
        return field.at(at.column, at.row) + t * (leaving.coarser_m - field.at(at.column, at.row));
    };
    std::vector<float> heights(field.samples.size(), NAN);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const Corner a = corner(indices[i]);
        const Corner b = corner(indices[i + 1]);
        const Corner c = corner(indices[i + 2]);
        const float area =
            static_cast<float>((b.column - a.column) * (c.row - a.row) - (c.column - a.column) * (b.row - a.row));
        const float at_a = height(indices[i]);
        const float at_b = height(indices[i + 1]);
        const float at_c = height(indices[i + 2]);
        for (int row = std::min({a.row, b.row, c.row}); row <= std::max({a.row, b.row, c.row}); ++row) {
            for (int column = std::min({a.column, b.column, c.column});
                 column <= std::max({a.column, b.column, c.column}); ++column) {
                const auto share = [&](const Corner& p, const Corner& q) {
                    return static_cast<float>((q.column - p.column) * (row - p.row) -
                                              (column - p.column) * (q.row - p.row)) /
                           area;
                };
                const float of_c = share(a, b);
                const float of_a = share(b, c);
                const float of_b = share(c, a);
                if (std::min({of_a, of_b, of_c}) < -1e-5F) continue;
                heights[static_cast<std::size_t>(row * kSide + column)] = of_a * at_a + of_b * at_b + of_c * at_c;
            }
        }
    }
    return heights;
}

// A camera low over the land that flies so far, and what it sees there.
struct Moment {
    Moment(const Blocks& blocks, float along_m) {
        const scene::Camera camera{{-20 + along_m, 24, 110 - along_m}, {along_m, 0, -along_m}, 60};
        frustum.emplace(scene::clip_from_view(camera, 1) * scene::view_from_world(camera));
        wish = {camera.eye_m, 469, 3.0F, 1'000'000};
        blocks.select(*frustum, wish, indices);
    }
    std::optional<Frustum> frustum;
    Blocks::Wish wish{};
    std::vector<std::uint32_t> indices;
};

struct Moved {
    float most_px = 0;  // that any vertex of the ground jumped on the screen beside the camera's own motion
    int switches = 0;   // frames in which other triangles were drawn
};

// A centimetre a frame, wherever on the way the triangles change.
Moved flown(bool is_eased) {
    const mesh::Field field = rugged(0.3F, 0.9F);
    const Blocks blocks(field, kCell_m, 16);
    Moved moved;
    constexpr float kFrame_m = 0.01F;
    constexpr int kFramesAStretch = 20;
    for (int stretch = 0; stretch < 120; ++stretch) {
        const float from_m = kFrame_m * kFramesAStretch * static_cast<float>(stretch);
        Moment last(blocks, from_m);
        if (last.indices == Moment(blocks, from_m + kFrame_m * kFramesAStretch).indices) continue;
        std::vector<float> before = drawn_heights(blocks, field, *last.frustum, last.wish, is_eased);
        for (int frame = 1; frame <= kFramesAStretch; ++frame) {
            Moment moment(blocks, from_m + kFrame_m * static_cast<float>(frame));
            std::vector<float> now = drawn_heights(blocks, field, *moment.frustum, moment.wish, is_eased);
            // Wherever a vertex was or is: there the surface has its corners.
            std::vector<std::uint32_t> vertices = last.indices;
            vertices.insert(vertices.end(), moment.indices.begin(), moment.indices.end());
            for (const std::uint32_t i : vertices) {
                if (std::isnan(now[i]) || std::isnan(before[i])) continue;
                const Corner at = corner(i);
                const glm::vec3 place{(static_cast<float>(at.column) - 64) * kCell_m, now[i],
                                      (static_cast<float>(at.row) - 64) * kCell_m};
                const float away_m = glm::length(place - moment.wish.eye_m);
                moved.most_px = std::max(moved.most_px, std::abs(now[i] - before[i]) * 469 / away_m);
            }
            moved.switches += moment.indices != last.indices;
            before = std::move(now);
            last = std::move(moment);
        }
    }
    return moved;
}

TEST(BlocksInMotion, NothingJumpsWhereALevelChanges) {
    const Moved eased = flown(true);
    EXPECT_GT(eased.switches, 20);
    EXPECT_LT(eased.most_px, 1.0F);
    EXPECT_GT(flown(false).most_px, 2.0F);
}

}  // namespace
}  // namespace quadrat::render::choose
