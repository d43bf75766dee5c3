// SPDX-License-Identifier: Apache-2.0
#include "render/choose/pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <tuple>

#include "mesh/displaced_sphere.hpp"
#include "scene/camera.hpp"

namespace quadrat::render::choose {
namespace {

// Balls of facets in a row away from the eye, each corner its own vertex.
scene::Stone balls(int count, int side) {
    scene::Stone stone;
    const mesh::Mesh ball = mesh::displaced_sphere(side, base::Seed{3});
    for (int i = 0; i < count; ++i) {
        const glm::vec3 middle_m{0, 0, -20.0F * static_cast<float>(1 << i)};
        for (const std::uint32_t index : ball.indices) {
            stone.mesh.indices.push_back(static_cast<std::uint32_t>(stone.mesh.positions_m.size()));
            stone.mesh.positions_m.push_back(middle_m + ball.positions_m[index]);
            stone.mesh.normals.push_back(glm::normalize(ball.positions_m[index]));
            stone.colours.emplace_back(0.1F * static_cast<float>(i));
        }
    }
    return stone;
}

Frustum ahead() {
    const scene::Camera camera{{0, 0, 0}, {0, 0, -100}, 42};
    return Frustum(scene::clip_from_view(camera, 1.5F) * scene::view_from_world(camera));
}

std::vector<std::uint32_t> selected(const Pieces& pieces, float error_px) {
    std::vector<std::uint32_t> indices;
    pieces.select(ahead(), {{0, 0, 0}, 500, error_px}, indices);
    return indices;
}

TEST(Pieces, AreWholeWhereNothingMayDiffer) {
    const scene::Stone stone = balls(3, 6);
    Pieces pieces(stone);
    const auto indices = selected(pieces, 1e-6F);
    ASSERT_EQ(indices.size(), stone.mesh.indices.size());
    const auto corners = pieces.take_corners();
    EXPECT_LE(corners.size(), Pieces::most_corners(stone));
    const auto before = [](const glm::vec3& a, const glm::vec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::vector<glm::vec3> drawn;
    for (const std::uint32_t i : indices) drawn.push_back(corners[i].at_m);
    std::vector<glm::vec3> given = stone.mesh.positions_m;
    std::ranges::sort(drawn, before);
    std::ranges::sort(given, before);
    EXPECT_EQ(drawn, given);
}

TEST(Pieces, AreCoarserTheMoreMayDifferAndGoneBelowAPixel) {
    const scene::Stone stone = balls(6, 8);
    const Pieces pieces(stone);
    std::size_t before = selected(pieces, 1e-6F).size();
    const std::size_t all = before;
    for (float error_px = 0.1F; error_px < 200; error_px *= 1.5F) {
        const auto indices = selected(pieces, error_px);
        EXPECT_EQ(indices.size() % 3, 0U);
        EXPECT_LE(indices.size(), before);
        before = indices.size();
    }
    EXPECT_LT(selected(pieces, 1).size(), all / 2);
    EXPECT_EQ(before, 0U);
}

TEST(Pieces, CoarserFacetsFaceOutwardAndKeepTheirColour) {
    const scene::Stone stone = balls(2, 8);
    Pieces pieces(stone);
    const auto indices = selected(pieces, 4);
    const auto corners = pieces.take_corners();
    ASSERT_FALSE(indices.empty());
    for (const std::uint32_t i : indices) {
        const bool is_near = corners[i].at_m.z > -30;
        const glm::vec3 middle_m{0, 0, is_near ? -20 : -40};
        EXPECT_GT(glm::dot(corners[i].normal, corners[i].at_m - middle_m), 0);
        EXPECT_NEAR(corners[i].colour.r, is_near ? 0 : 0.1F, 1e-5F);
    }
}

TEST(Pieces, OfNoStoneAreNone) {
    Pieces pieces{scene::Stone{}};
    EXPECT_TRUE(selected(pieces, 1).empty());
    EXPECT_TRUE(pieces.take_corners().empty());
}

}  // namespace
}  // namespace quadrat::render::choose
