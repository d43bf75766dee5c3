// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mesh/progressive.hpp"
#include "support/manifold.hpp"
#include "synthesis/trees/grammar.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/turtle.hpp"

namespace quadrat::synthesis::trees {
namespace {

scene::Wood trunk_of(const char* grammar_name) {
    const Grammar grammar = library_grammar(grammar_name);
    TurtleOptions options = options_of(grammar);
    options.length = 2;
    options.radius_per_width = 0.03F;
    DeriveOptions how;
    how.steps = 10;
    TreeSkeleton skeleton = interpret(derive(grammar, how).word, options, base::Seed{1});
    skeleton.limbs.resize(1);
    std::erase_if(skeleton.sites, [](const Site& site) { return site.limb > 0; });
    measure(skeleton);
    MetaTubeDetail detail;
    detail.cell_m = cell_for(skeleton, 8'000);
    detail.sweeps_twigs = false;
    return mesh_meta_tubes(skeleton, detail);
}

TEST(TreeLevels, OfATrunkKeepItsVolumeAndItsAges) {
    for (const char* name : {"changed-c", "abop-b"}) {
        const scene::Wood wood = trunk_of(name);
        ASSERT_GT(wood.mesh.positions_m.size(), 300U) << name;
        mesh::ProgressiveOptions options;
        options.fewest = 12;
        options.attributes = wood.ages;
        options.attributes_a_vertex = 1;
        const mesh::Progressive progressive = mesh::make_progressive(wood.mesh, options);
        ASSERT_GT(progressive.levels.size(), 4U);
        const double whole = tests::volume_of(wood.mesh);
        EXPECT_NEAR(tests::volume_of(progressive.levels[1].mesh), whole, 0.01 * whole) << name;
        EXPECT_NEAR(tests::volume_of(progressive.levels[4].mesh), whole, 0.05 * whole) << name;
        for (const auto& level : progressive.levels) {
            EXPECT_EQ(tests::manifold_fault(level.mesh.indices, level.mesh.positions_m.size()), "");
            for (const float age : level.attributes) {
                EXPECT_GE(age, 0);
                EXPECT_LE(age, 1);
            }
        }
    }
}

// D = alpha E^beta is free of scale. A trunk is round: of its many like edges rounding decides which goes first, and a
// level's error is its dearest collapse; so they are the same only where the scale is a power of two, and within half a
// level where it is not.
TEST(TreeLevels, OfATrunkOfTenTimesTheSizeChangeAtTenTimesTheDistance) {
    mesh::Mesh trunk = trunk_of("changed-c").mesh;
    mesh::ProgressiveOptions options;
    options.fewest = 12;
    const mesh::Progressive one = mesh::make_progressive(trunk, options);
    for (glm::vec3& position_m : trunk.positions_m) position_m *= 10.0F;
    const mesh::Progressive ten = mesh::make_progressive(trunk, options);
    ASSERT_GT(one.levels.size(), 4U);
    ASSERT_EQ(ten.levels.size(), one.levels.size());
    constexpr float kAlpha = 500;
    for (std::size_t i = 1; i < one.levels.size(); ++i) {
        const float distance_m = mesh::ideal_distance_m(one.levels[i], kAlpha);
        EXPECT_NEAR(mesh::ideal_distance_m(ten.levels[i], kAlpha), 10 * distance_m, 5 * distance_m) << i;
        EXPECT_NEAR(mesh::level_at(ten, 10 * distance_m, kAlpha), mesh::level_at(one, distance_m, kAlpha), 0.5F) << i;
    }
    for (glm::vec3& position_m : trunk.positions_m) position_m *= 1.6F;
    const mesh::Progressive sixteen = mesh::make_progressive(trunk, options);
    for (glm::vec3& position_m : trunk.positions_m) position_m *= 16.0F;
    const mesh::Progressive times_16 = mesh::make_progressive(trunk, options);
    ASSERT_EQ(times_16.levels.size(), sixteen.levels.size());
    for (std::size_t i = 0; i < sixteen.levels.size(); ++i)
        EXPECT_EQ(times_16.levels[i].error_m, 16 * sixteen.levels[i].error_m) << i;
}

TEST(TreeLevels, OfASmoothTreeKeepItsVolume) {
    const Grammar grammar = library_grammar("changed-c");
    TurtleOptions turtle = options_of(grammar);
    turtle.length = 2;
    turtle.radius_per_width = 0.03F;
    DeriveOptions how;
    how.steps = 6;
    const TreeSkeleton skeleton = interpret(derive(grammar, how).word, turtle, base::Seed{1});
    MetaTubeDetail detail;
    detail.cell_m = cell_for(skeleton, 20'000);
    detail.sweeps_twigs = false;
    const scene::Wood wood = mesh_meta_tubes(skeleton, detail);
    const mesh::Progressive progressive = mesh::make_progressive(wood.mesh);
    ASSERT_GT(progressive.levels.size(), 4U);
    const double whole = tests::volume_of(wood.mesh);
    EXPECT_NEAR(tests::volume_of(progressive.levels[1].mesh), whole, 0.01 * whole);
    EXPECT_NEAR(tests::volume_of(progressive.levels[4].mesh), whole, 0.05 * whole);
}

}  // namespace
}  // namespace quadrat::synthesis::trees
