// SPDX-License-Identifier: Apache-2.0
#include "render/passes/chunks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/seed.hpp"
#include "scene/camera.hpp"

namespace quadrat::render::passes {
namespace {

mesh::Mesh scattered(std::size_t triangles) {
    mesh::Mesh mesh;
    base::RandomStream random{base::Seed{4}};
    for (std::size_t i = 0; i < triangles; ++i) {
        const float x = random.between(-300, 300);
        const float y = random.between(0, 20);
        const glm::vec3 at{x, y, random.between(-300, 300)};
        for (const glm::vec3 corner : {at, at + glm::vec3{2, 0, 0}, at + glm::vec3{0, 1, 2}}) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions_m.size()));
            mesh.positions_m.push_back(corner);
        }
    }
    return mesh;
}

using Triangle = std::array<std::uint32_t, 3>;

Frustum seen_from(const scene::Camera& camera) {
    return Frustum(scene::clip_from_view(camera, 1.5F) * scene::view_from_world(camera));
}

TEST(Chunks, HoldEveryTriangleOnce) {
    const mesh::Mesh mesh = scattered(500);
    Chunks chunks(mesh, 64);
    EXPECT_EQ(chunks.index_count(), mesh.indices.size());
    const auto ordered = chunks.take_indices();
    std::set<Triangle> before;
    std::set<Triangle> after;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        before.insert({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
        after.insert({ordered[i], ordered[i + 1], ordered[i + 2]});
    }
    EXPECT_EQ(before, after);
    EXPECT_EQ(chunks.seen(seen_from({{0, 900, 1}, {0, 0, 0}, 60})),
              (std::vector<Chunks::Range>{{0, mesh.indices.size()}}));
}

TEST(Chunks, LeaveOutNothingThatIsSeenAndMostOfWhatIsNot) {
    const mesh::Mesh mesh = scattered(2000);
    Chunks chunks(mesh, 48);
    const auto ordered = chunks.take_indices();
    for (int turn = 0; turn < 8; ++turn) {
        const float way = 0.785F * static_cast<float>(turn);
        const scene::Camera camera{{0, 8, 0}, {std::sin(way), 8, -std::cos(way)}, 45};
        const Frustum frustum = seen_from(camera);
        const auto ranges = chunks.seen(frustum);
        std::size_t drawn = 0;
        for (const auto& range : ranges) drawn += range.count;
        EXPECT_GT(drawn, 0U);
        EXPECT_LT(drawn, ordered.size() / 2);
        for (std::size_t i = 0; i < ordered.size(); ++i) {
            if (!frustum.may_see_sphere(mesh.positions_m[ordered[i]], 0)) continue;
            EXPECT_TRUE(std::ranges::any_of(
                ranges, [&](const auto& range) { return i >= range.first && i < range.first + range.count; }));
        }
    }
}

TEST(Chunks, OfNothingShowNothing) {
    EXPECT_TRUE(Chunks{}.seen(seen_from({{0, 900, 1}, {0, 0, 0}, 60})).empty());
    EXPECT_TRUE(Chunks(mesh::Mesh{}, 10).seen(seen_from({{0, 900, 1}, {0, 0, 0}, 60})).empty());
}

}  // namespace
}  // namespace quadrat::render::passes
