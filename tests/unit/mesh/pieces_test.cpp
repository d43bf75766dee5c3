// SPDX-License-Identifier: Apache-2.0
#include "mesh/pieces.hpp"

#include <gtest/gtest.h>

namespace quadrat::mesh {
namespace {

using Pieces = std::vector<std::vector<std::uint32_t>>;

TEST(Pieces, HangTogetherByPlacesNotByIndices) {
    Mesh mesh;
    EXPECT_TRUE(pieces_of(mesh).empty());
    // Two facets with corners of their own along one edge; another triangle elsewhere between them.
    mesh.positions_m = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 0, 0}, {9, 1, 0},
                        {9, 0, 1}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.indices = {0, 1, 2, 3, 4, 5, 6, 8, 7};
    EXPECT_EQ(pieces_of(mesh), (Pieces{{0, 6}, {3}}));
    mesh.positions_m[7] = {0, 5, 0};
    EXPECT_EQ(pieces_of(mesh), (Pieces{{0, 6}, {3}})) << "a corner is enough";
    mesh.positions_m[6] = {1, 5, 0};
    EXPECT_EQ(pieces_of(mesh), (Pieces{{0}, {3}, {6}}));
}

}  // namespace
}  // namespace quadrat::mesh
