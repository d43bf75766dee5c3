// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/bare_twigs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/tree_parameters.hpp"
#include "synthesis/trees/form.hpp"
#include "synthesis/trees/species.hpp"
#include "synthesis/trees/year.hpp"

namespace quadrat::synthesis::trees {
namespace {

const glm::vec3 kBark{0.2F, 0.15F, 0.1F};

TreeSkeleton oak_in(float season) {
    scene::TreeParameters p;
    p.tree_habit = static_cast<float>(habit_named("oak"));
    TreeSkeleton skeleton = skeleton_of_species(form_of(p, Rank::First), base::Seed{7});
    pass_year(skeleton, {season, 1, 0}, base::Seed{8});
    return skeleton;
}

scene::Leaves twigs_in(float season, std::size_t most = 400) {
    return bare_twigs(oak_in(season), {4, kBark}, spray_shape(LeafKind::Lobed), most, base::Seed{9});
}

TEST(BareTwigs, StandWhereLeavesHaveFallenAndNowhereElse) {
    EXPECT_EQ(twigs_in(kMidsummer).blades, 0U);
    const TreeSkeleton winter = oak_in(1);
    const scene::Leaves twigs = twigs_in(1);
    EXPECT_GT(twigs.blades, 300U);
    EXPECT_LT(twigs_in(2 * kMidsummer).blades, twigs.blades / 4) << "of a crown that still has most of its leaves";
    for (const scene::Leaves::Vertex& vertex : twigs.vertices)
        ASSERT_TRUE(std::ranges::any_of(winter.sites, [&](const Site& site) {
            return site.organ == Organ::None && glm::distance(site.at_m, vertex.site_m) < 0.05F;
        }));
}

TEST(BareTwigs, AreThinAndBlades) {
    const scene::Leaves twigs = twigs_in(1);
    ASSERT_EQ(twigs.indices.size(), twigs.blades * spray_shape(LeafKind::Lobed).triangles.size());
    const std::size_t corners = twigs.vertices.size() / twigs.blades;
    for (std::size_t blade = 0; blade < twigs.blades; ++blade) {
        const auto* first = twigs.vertices.data() + blade * corners;
        const auto tip = std::max_element(first, first + corners, [](const auto& a, const auto& b) {
            return glm::length(a.corner_m) < glm::length(b.corner_m);
        });
        EXPECT_GT(glm::length(tip->corner_m), 0.3F);
        EXPECT_LT(glm::length(tip->corner_m), 1.5F);
        EXPECT_NEAR(glm::length(first->normal), 1, 1e-4F);
    }
}

TEST(BareTwigs, AreNoMoreThanTheMostAndTheSameAgain) {
    EXPECT_EQ(twigs_in(1, 50).blades, 50U);
    EXPECT_EQ(twigs_in(1, 0).blades, 0U);
    const scene::Leaves once = twigs_in(1);
    const scene::Leaves again = twigs_in(1);
    ASSERT_EQ(once.vertices.size(), again.vertices.size());
    for (std::size_t i = 0; i < once.vertices.size(); ++i)
        ASSERT_EQ(once.vertices[i].corner_m, again.vertices[i].corner_m);
}

scene::Species blue_barked_oak(float season) {
    scene::TreeParameters p;
    p.tree_habit = static_cast<float>(habit_named("oak"));
    p.tree_season = season;
    Form form = form_of(p, Rank::First);
    form.bark = {0.02F, 0.02F, 0.9F};
    return make_species(form, base::Seed{7});
}

bool is_twig(const glm::vec3& colour) { return colour.b > 2 * colour.r; }

// Drawn far away, a mass stands for leaves: twigs let the sky through.
TEST(BareTwigs, AddNothingToTheMassThatStandsForACrownFarAway) {
    const scene::Species autumn = blue_barked_oak(0.8F);
    ASSERT_FALSE(autumn.masses.empty());
    for (const scene::CrownMass& mass : autumn.masses) EXPECT_TRUE(std::ranges::none_of(mass.colours, is_twig));
    EXPECT_TRUE(std::ranges::any_of(autumn.leaves.vertices, is_twig, &scene::Leaves::Vertex::colour));
}

float area_m2(const mesh::Mesh& mesh) {
    float sum = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return mesh.positions_m[mesh.indices[i + k]]; };
        sum += 0.5F * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    }
    return sum;
}

TEST(LeaflessCrown, IsAllBarkAndHasNoLeafLeftToFloatAboutIt) {
    const scene::Species winter = blue_barked_oak(1);
    EXPECT_GT(winter.leaves.blades, 600U);
    EXPECT_LE(winter.leaves.blades, 1600U);
    EXPECT_EQ(winter.leaves.indices_per_blade(), 3U);
    EXPECT_TRUE(std::ranges::all_of(winter.leaves.vertices, is_twig, &scene::Leaves::Vertex::colour));
}

// With the strongest first, so that the few that are drawn far away are its limbs.
TEST(LeaflessCrown, BeginsWithItsLimbsWhereTheyAre) {
    const TreeSkeleton winter = oak_in(1);
    const scene::Leaves crown = leafless_crown(winter, {4, kBark}, 800, base::Seed{3});
    for (std::size_t blade = 0; blade < 12; ++blade) {
        const scene::Leaves::Vertex& foot = crown.vertices[3 * blade];
        EXPECT_TRUE(std::ranges::any_of(winter.limbs, [&](const Limb& limb) {
            return limb.order > 0 && std::ranges::any_of(limb.nodes, [&](const Limb::Node& node) {
                       return glm::distance(node.at_m, foot.site_m) < 1.0e-4F;
                   });
        })) << blade;
    }
    const auto wide = [&](std::size_t blade) {
        return glm::distance(crown.vertices[3 * blade].corner_m, crown.vertices[3 * blade + 1].corner_m);
    };
    EXPECT_GT(wide(0), 3 * wide(crown.blades - 1));
}

// From afar a dead wood is strokes that the sky shows between, not a row of stakes, and goes on as fewer and larger
// ones.
TEST(LeaflessMasses, AreStrokesThatTheSkyShowsBetween) {
    const TreeSkeleton winter = oak_in(1);
    const auto masses = leafless_masses(winter, {4, kBark}, base::Seed{3});
    ASSERT_GE(masses.size(), 3U);
    const float crown_m2 = 8 * (winter.high_m.y - winter.low_m.y);
    for (std::size_t level = 0; level < masses.size(); ++level) {
        const scene::CrownMass& mass = masses[level];
        EXPECT_EQ(mass.sprays, mass.mesh.triangle_count());
        EXPECT_LT(area_m2(mass.mesh), 0.35F * crown_m2);
        EXPECT_GT(area_m2(mass.mesh), 0.04F * crown_m2);
        const bool is_last = level + 1 == masses.size();
        EXPECT_EQ(mass.coarser_m.empty(), is_last);
        if (is_last) continue;
        mesh::Mesh become = mass.mesh;
        become.positions_m = mass.coarser_m;
        EXPECT_NEAR(area_m2(become), area_m2(masses[level + 1].mesh), 0.01F * crown_m2) << level;
    }
    TreeSkeleton dead = winter;  // no bud is left on it
    dead.sites.clear();
    EXPECT_GE(leafless_masses(dead, {4, kBark}, base::Seed{3}).size(), 3U);
    TreeSkeleton pole = dead;
    pole.limbs.resize(1);
    EXPECT_TRUE(leafless_masses(pole, {4, kBark}, base::Seed{3}).empty());
}

}  // namespace
}  // namespace quadrat::synthesis::trees
