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
    return bare_twigs(oak_in(season), 4, kBark, spray_shape(LeafKind::Lobed), most, base::Seed{9});
}

TEST(BareTwigs, StandWhereLeavesHaveFallenAndNowhereElse) {
    EXPECT_EQ(twigs_in(kMidsummer).blades, 0U);
    const TreeSkeleton winter = oak_in(1);
    const scene::Leaves twigs = twigs_in(1);
    EXPECT_GT(twigs.blades, 300U);
    EXPECT_LT(twigs_in(2 * kMidsummer).blades, twigs.blades / 4) << "of a crown that still has most of its leaves";
    for (const scene::Leaves::Vertex& vertex : twigs.vertices)
        ASSERT_TRUE(std::ranges::any_of(
            winter.sites, [&](const Site& site) { return site.organ == Organ::None && site.at_m == vertex.site_m; }));
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

// Drawn far away, a mass stands for leaves: twigs let the sky through.
TEST(BareTwigs, AddNothingToTheMassThatStandsForACrownFarAway) {
    scene::TreeParameters p;
    p.tree_habit = static_cast<float>(habit_named("oak"));
    p.tree_season = 1;
    Form form = form_of(p, Rank::First);
    form.bark = {0.02F, 0.02F, 0.9F};
    const scene::Species winter = make_species(form, base::Seed{7});
    const auto is_twig = [](const glm::vec3& colour) { return colour.b > 2 * colour.r; };
    for (const scene::CrownMass& mass : winter.masses) EXPECT_TRUE(std::ranges::none_of(mass.colours, is_twig));
    EXPECT_TRUE(std::ranges::any_of(winter.leaves.vertices, is_twig, &scene::Leaves::Vertex::colour));
    EXPECT_GT(winter.leaves.blades, 300U);
}

}  // namespace
}  // namespace quadrat::synthesis::trees
