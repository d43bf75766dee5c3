// SPDX-License-Identifier: Apache-2.0
// Beside meshoptimizer: vertices of ours may leave the surface, its may not.
#include <gtest/gtest.h>

#ifdef QUADRAT_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>

#include "mesh/displaced_sphere.hpp"
#include "mesh/nearness.hpp"
#include "mesh/progressive.hpp"

namespace quadrat::mesh {
namespace {

Mesh simplified_by_peer(const Mesh& mesh, std::size_t vertices) {
    Mesh coarse = mesh;
    const std::size_t count =
        meshopt_simplify(coarse.indices.data(), mesh.indices.data(), mesh.indices.size(), &mesh.positions_m[0].x,
                         mesh.positions_m.size(), sizeof(glm::vec3), 6 * (vertices - 2), 1e9F, 0, nullptr);
    coarse.indices.resize(count);
    std::vector<glm::vec3> used;
    std::vector<std::uint32_t> place(mesh.positions_m.size(), 0xFFFFFFFFU);
    for (std::uint32_t& index : coarse.indices) {
        if (place[index] == 0xFFFFFFFFU) {
            place[index] = static_cast<std::uint32_t>(used.size());
            used.push_back(coarse.positions_m[index]);
        }
        index = place[index];
    }
    coarse.positions_m = std::move(used);
    return coarse;
}

TEST(ProgressiveMesh, LiesNearerThanMeshoptimizersAtEveryLevel) {
    const Mesh exact = displaced_sphere(64, base::Seed{1});
    const Progressive progressive = make_progressive(exact);
    Mesh peer = exact;
    for (std::size_t i = 1; i < progressive.levels.size(); ++i) {
        const Mesh& level = progressive.levels[i].mesh;
        peer = simplified_by_peer(peer, level.positions_m.size());
        const Deviation ours = deviation_of(level, exact);
        const Deviation theirs = deviation_of(peer, exact);
        EXPECT_LT(ours.rms_m, 0.95 * theirs.rms_m) << level.positions_m.size();
        EXPECT_LT(ours.most_m, 1.25 * theirs.most_m) << level.positions_m.size();
    }
}

}  // namespace
}  // namespace quadrat::mesh
#else
TEST(ProgressiveMesh, LiesNearerThanMeshoptimizersAtEveryLevel) { GTEST_SKIP() << "libmeshoptimizer-dev is missing"; }
#endif
