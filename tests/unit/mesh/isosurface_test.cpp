// SPDX-License-Identifier: Apache-2.0
#include "mesh/isosurface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/seed.hpp"
#include "support/manifold.hpp"

namespace quadrat::mesh {
namespace {

// A field over so many blocks each way, outside at its rim.
template <typename Value>
SparseField field_of(int blocks, const Value& value) {
    SparseField field(glm::ivec3{blocks});
    const int last = blocks * SparseField::kSide - 1;
    for (int z = 0; z <= last; ++z) {
        for (int y = 0; y <= last; ++y) {
            for (int x = 0; x <= last; ++x) {
                const bool is_rim = x == 0 || y == 0 || z == 0 || x == last || y == last || z == last;
                const int block = field.make({x / 8, y / 8, z / 8});
                field.block(block)[(z % 8 * 8 + y % 8) * 8 + x % 8] = is_rim ? -1.0F : value(x, y, z);
            }
        }
    }
    return field;
}

Mesh mesh_of(const Surface& surface) {
    Mesh mesh;
    mesh.positions_m = surface.positions;
    mesh.indices = surface.indices;
    return mesh;
}

TEST(Isosurface, OfNoiseIsAClosedManifoldWhateverTheCells) {
    // White noise has every one of the 256 cells, many times over, and pinched faces besides.
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const float share = 0.2F + 0.05F * static_cast<float>(seed);
        const SparseField field = field_of(
            3, [&](int x, int y, int z) { return share - base::unit_of(base::hash_of(base::Seed{seed}, x, y, z)); });
        const Surface surface = polygonise(field);
        ASSERT_GT(surface.indices.size(), 3000U);
        EXPECT_EQ(tests::manifold_fault(surface.indices, surface.positions.size()), "") << seed;
        EXPECT_GT(tests::volume_of(mesh_of(surface)), 0) << seed;
    }
}

TEST(Isosurface, HasAVertexMoreWhereTwoSheetsMeetTwice) {
    // Two corners across a face, and nothing else of either cell.
    const SparseField field = field_of(2, [](int x, int y, int z) {
        const bool is_in =
            z >= 6 && z <= 8 &&
            ((x == 6 && y == 6) || (x == 7 && y == 7) || (z != 7 && (x == 6 || x == 7) && (y == 6 || y == 7)));
        return is_in ? 0.5F : -0.5F;
    });
    const Surface surface = polygonise(field);
    EXPECT_EQ(tests::manifold_fault(surface.indices, surface.positions.size()), "");
}

TEST(Isosurface, OfABallHasItsVolumeAndFacesOutward) {
    constexpr float kRadius = 9.3F;
    const SparseField field = field_of(4, [](int x, int y, int z) {
        return kRadius -
               std::hypot(static_cast<float>(x) - 15.4F, static_cast<float>(y) - 15.7F, static_cast<float>(z) - 15.1F);
    });
    const Mesh mesh = mesh_of(polygonise(field));
    EXPECT_NEAR(tests::volume_of(mesh), 4.18879 * kRadius * kRadius * kRadius, 0.03 * 3369);
    EXPECT_EQ(tests::degenerate_triangles(mesh), 0U);
    for (const glm::vec3& p : mesh.positions_m)
        EXPECT_NEAR(glm::distance(p, glm::vec3{15.4F, 15.7F, 15.1F}), kRadius, 0.35F);
}

TEST(Isosurface, OfNothingIsEmpty) {
    EXPECT_TRUE(polygonise(SparseField{glm::ivec3{2}}).indices.empty());
    EXPECT_TRUE(polygonise(field_of(2, [](int, int, int) { return -1.0F; })).indices.empty());
}

TEST(SparseField, HoldsOnlyBlocksWithinItsLattice) {
    SparseField field(glm::ivec3{2, 3, 4});
    EXPECT_EQ(field.make({1, 2, 3}), 0);
    EXPECT_EQ(field.make({1, 2, 3}), 0);
    EXPECT_EQ(field.make({2, 0, 0}), -1);
    EXPECT_EQ(field.make({0, -1, 0}), -1);
    EXPECT_EQ(field.count(), 1U);
    EXPECT_EQ(field.at({0, 0, 0}), -1.0F);
}

}  // namespace
}  // namespace quadrat::mesh
