// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "synthesis/grow.hpp"
#include "synthesis/trees/abop.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/turtle.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

TEST(LSystem, DerivesTheBooksFigureTwoSixA) {
    const trees::Grammar grammar = trees::honda_grammar(trees::book_tree(0));
    EXPECT_EQ(trees::text_of(trees::derive(grammar, 0)), "A(1,10)");
    EXPECT_EQ(trees::text_of(trees::derive(grammar, 1)), "!(10)F(1)[&(45)B(0.6,7.07)]/(137.5)A(0.9,7.07)");
    EXPECT_EQ(trees::text_of(trees::derive(grammar, 2)),
              "!(10)F(1)[&(45)!(7.07)F(0.6)[-(45)$C(0.36,4.998)]C(0.54,4.998)]/(137.5)"
              "!(7.07)F(0.9)[&(45)B(0.54,4.998)]/(137.5)A(0.81,4.998)");
}

TEST(LSystem, CarriesTheBooksConstantsOfTableTwoOne) {
    const auto constants = [](int type) {
        const trees::HondaTree t = trees::book_tree(type);
        return std::array{t.r1, t.r2, t.a0, t.a2, t.d, t.wr};
    };
    EXPECT_EQ(constants(0), (std::array{0.9F, 0.6F, 45.0F, 45.0F, 137.5F, 0.707F}));
    EXPECT_EQ(constants(1), (std::array{0.9F, 0.9F, 45.0F, 45.0F, 137.5F, 0.707F}));
    EXPECT_EQ(constants(2), (std::array{0.9F, 0.8F, 45.0F, 45.0F, 137.5F, 0.707F}));
    EXPECT_EQ(constants(3), (std::array{0.9F, 0.7F, 30.0F, -30.0F, 137.5F, 0.707F}));
}

TEST(LSystem, GivesTheBookAsPrintedAtTheGenesDefaults) {
    for (int type = 0; type < 4; ++type) {
        scene::TreeParameters p;
        p.type = type;
        p.branch_angle_deg = 41.25F;
        const trees::HondaTree ours = trees::gene_tree(p);
        const trees::HondaTree book = trees::book_tree(type);
        EXPECT_NEAR(ours.r1, book.r1, 1e-5);
        EXPECT_NEAR(ours.r2, book.r2, 1e-5);
        EXPECT_NEAR(ours.a0, book.a0, 1e-4);
        EXPECT_NEAR(ours.a2, book.a2, 1e-4);
    }
}

TEST(LSystem, StopsBeforeAWordOutgrowsItsBudget) {
    const trees::Grammar doubling{{trees::module('X')}, {{'X', [](const trees::Module& self, trees::Word& next) {
                                                              next.insert(next.end(), {self, self});
                                                          }}}};
    EXPECT_EQ(trees::derive(doubling, 60, 1000).size(), 512U);
}

TEST(Turtle, WalksASquareBackToItsStart) {
    trees::Word word{trees::module('!', 1)};
    for (int i = 0; i < 4; ++i) {
        word.push_back(trees::module('F', 1));
        word.push_back(trees::module('&', 90));
    }
    const trees::TreeSkeleton skeleton = trees::interpret(word, {.internode_m = 1, .leafy_from = 99}, base::Seed{1});
    ASSERT_EQ(skeleton.limbs.size(), 1U);
    EXPECT_NEAR(glm::length(skeleton.limbs[0].nodes.back().at_m), 0, 1e-5);
    EXPECT_NEAR(skeleton.longest_path_m, 4, 1e-5);
}

TEST(Turtle, BeginsEveryLimbOnItsBearer) {
    const trees::Word word = trees::derive(trees::honda_grammar(trees::book_tree(2)), 7);
    const trees::TreeSkeleton skeleton = trees::interpret(word, {.gnarl_deg = 5}, base::Seed{3});
    ASSERT_GT(skeleton.limbs.size(), 50U);
    for (std::size_t i = 1; i < skeleton.limbs.size(); ++i) {
        const trees::Limb& limb = skeleton.limbs[i];
        ASSERT_GE(limb.parent, 0);
        ASSERT_LT(limb.parent, static_cast<int>(i));
        bool is_on_bearer = false;
        for (const auto& node : skeleton.limbs[limb.parent].nodes)
            is_on_bearer = is_on_bearer || glm::distance(node.at_m, limb.nodes.front().at_m) < 1e-4F;
        EXPECT_TRUE(is_on_bearer) << i;
        EXPECT_LE(limb.nodes.front().radius_m, skeleton.limbs[limb.parent].nodes.front().radius_m);
    }
}

// Every edge is shared by two triangles that run along it in opposite directions.
void expect_closed(const mesh::Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        ASSERT_EQ(edges.count({edge.second, edge.first}), 1U);
    }
}

double volume(const mesh::Mesh& mesh) {
    double six = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto& p = mesh.positions_m;
        six += glm::dot(p[mesh.indices[i]], glm::cross(p[mesh.indices[i + 1]], p[mesh.indices[i + 2]]));
    }
    return six / 6;
}

void expect_sound(const scene::Wood& wood) {
    const std::size_t n = wood.mesh.positions_m.size();
    ASSERT_EQ(wood.mesh.normals.size(), n);
    ASSERT_EQ(wood.ages.size(), n);
    ASSERT_EQ(wood.sways.size(), n);
    for (const auto index : wood.mesh.indices) ASSERT_LT(index, n);
    for (std::size_t i = 0; i < n; ++i) {
        ASSERT_TRUE(std::isfinite(glm::dot(wood.mesh.positions_m[i], wood.mesh.positions_m[i])));
        ASSERT_NEAR(glm::length(wood.mesh.normals[i]), 1, 1e-3);
        ASSERT_TRUE(wood.ages[i] >= 0 && wood.ages[i] <= 1);
        ASSERT_TRUE(wood.sways[i] >= 0 && wood.sways[i] <= 1);
    }
    expect_closed(wood.mesh);
    if (n > 0) {
        EXPECT_GT(volume(wood.mesh), 0);
    }
}

class EveryTreeType : public testing::TestWithParam<int> {};

TEST_P(EveryTreeType, GrowsSoundClosedWoodAndLeavesWithinItsBudget) {
    scene::TreeParameters p;
    p.type = GetParam();
    const scene::Flora flora = grow_trees(p, base::Seed{77});
    ASSERT_GE(flora.species.size(), 4U);
    for (const scene::Species& species : flora.species) {
        ASSERT_FALSE(species.wood.empty());
        for (const scene::Wood& wood : species.wood) expect_sound(wood);
        const auto per_blade = species.leaves.indices_per_blade();
        EXPECT_EQ(per_blade * species.leaves.blades, species.leaves.indices.size());
        EXPECT_EQ(per_blade % 3, 0U);
        for (const auto index : species.leaves.indices) ASSERT_LT(index, species.leaves.vertices.size());
        for (const auto& v : species.leaves.vertices) {
            ASSERT_NEAR(glm::length(v.normal), 1, 1e-3);
            ASSERT_TRUE(
                std::isfinite(v.site_m.x + v.site_m.y + v.site_m.z + v.corner_m.x + v.corner_m.y + v.corner_m.z));
            ASSERT_TRUE(v.shade > 0 && v.shade <= 1 && v.age >= 0 && v.age <= 1 && v.sway >= 0 && v.sway <= 1);
        }
    }
    const scene::Species& tree = flora.species.front();
    EXPECT_LE(tree.wood[0].mesh.triangle_count() + tree.leaves.indices.size() / 3, 8000U);
    EXPECT_LE(tree.wood[1].mesh.triangle_count(), 1500U);
    EXPECT_LE(tree.wood[2].mesh.triangle_count(), 300U);
    EXPECT_GT(tree.height_m, 5);
    EXPECT_LT(tree.height_m, 24);
}

TEST_P(EveryTreeType, CoversItsWholeCrownWithAPrefixOfItsLeaves) {
    scene::TreeParameters p;
    p.type = GetParam();
    const scene::Leaves leaves = grow_trees(p, base::Seed{5}).species.front().leaves;
    const auto bounds = [&](std::size_t blades) {
        glm::vec3 low{1e6F};
        glm::vec3 high{-1e6F};
        for (std::size_t i = 0; i < 4 * blades; ++i) {
            low = glm::min(low, leaves.vertices[i].site_m);
            high = glm::max(high, leaves.vertices[i].site_m);
        }
        return high - low;
    };
    const glm::vec3 part = bounds(leaves.blades / 8);
    const glm::vec3 whole = bounds(leaves.blades);
    for (int i = 0; i < 3; ++i) EXPECT_GT(part[i], 0.65F * whole[i]);
}

INSTANTIATE_TEST_SUITE_P(All, EveryTreeType, testing::Range(0, 8));

TEST(LimbMesh, GrowsFromTheRootOutward) {
    const trees::Word word = trees::derive(trees::honda_grammar(trees::book_tree(1)), 6);
    const trees::TreeSkeleton skeleton = trees::interpret(word, {}, base::Seed{3});
    const scene::Wood wood = trees::mesh_limbs(skeleton, {});
    EXPECT_EQ(wood.ages.front(), 0);
    EXPECT_GT(*std::max_element(wood.ages.begin(), wood.ages.end()), 0.85F);
}

}  // namespace
