// SPDX-License-Identifier: Apache-2.0
// The twig that bears a spray leads to the limb that the spray grows on.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/nearness.hpp"
#include "scene/tree_parameters.hpp"
#include "synthesis/trees/foliage.hpp"
#include "synthesis/trees/form.hpp"
#include "synthesis/trees/species.hpp"

namespace quadrat::synthesis::trees {
namespace {

float to_segment_m(const glm::vec3& at, const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = b - a;
    const float t = std::clamp(glm::dot(at - a, d) / std::max(glm::dot(d, d), 1.0e-9F), 0.0F, 1.0F);
    return glm::distance(at, a + t * d);
}

float to_limbs_m(const TreeSkeleton& skeleton, const glm::vec3& at) {
    float nearest = 1.0e9F;
    for (const Limb& limb : skeleton.limbs)
        for (std::size_t i = 1; i < limb.nodes.size(); ++i)
            nearest = std::min(nearest, to_segment_m(at, limb.nodes[i - 1].at_m, limb.nodes[i].at_m));
    return nearest;
}

TEST(SprayTwigs, BeginOnALimbOrTowardOneThatIsFar) {
    for (const char* kind : {"oak", "willow", "beech"}) {
        scene::TreeParameters p;
        p.tree_habit = static_cast<float>(habit_named(kind));
        const TreeSkeleton skeleton = skeleton_of_species(form_of(p, Rank::First), base::Seed{7});
        FoliageOptions options;
        options.kind = LeafKind::Lobed;
        options.blades = 200;
        const LeafShape shape = shape_of(options);
        ASSERT_EQ(shape.twig_foot.size(), 2U);
        const scene::Leaves leaves = make_foliage(skeleton, options, base::Seed{3});
        const std::size_t corners = shape.outline.size();
        int on_limb = 0;
        for (std::size_t blade = 0; blade < leaves.blades; ++blade) {
            const auto& left = leaves.vertices[blade * corners + shape.twig_foot[0]];
            const auto& right = leaves.vertices[blade * corners + shape.twig_foot[1]];
            const glm::vec3 foot = left.site_m + 0.5F * (left.corner_m + right.corner_m);
            EXPECT_LE(glm::distance(foot, left.site_m), 1.5F * 1.2F * options.length_m + 1.0e-3F) << kind;
            const float from_limb_m = to_limbs_m(skeleton, foot);
            EXPECT_LE(from_limb_m, to_limbs_m(skeleton, left.site_m) + 0.02F) << kind;
            if (from_limb_m < 0.02F) ++on_limb;
        }
        EXPECT_GT(on_limb, static_cast<int>(leaves.blades) / 2) << kind;
    }
}

TEST(SprayLeaves, AreDarkerAtTheirFootThanAtTheirTip) {
    for (const LeafKind kind : {LeafKind::Ovate, LeafKind::Lance, LeafKind::Round, LeafKind::Lobed, LeafKind::Heart}) {
        const LeafShape& spray = spray_shape(kind);
        int leaves = 0;
        for (std::size_t v = 0; v + 2 < spray.on_blade.size(); ++v) {
            // A leaf's corners run from its foot by one side to its tip.
            if (spray.on_blade[v] != glm::vec2{0, 0} || spray.on_blade[v + 2] != glm::vec2{0, 1}) continue;
            EXPECT_LT(spray.lightness[v], 0.8F * spray.lightness[v + 2]);
            ++leaves;
        }
        EXPECT_GE(leaves, 3) << static_cast<int>(kind);
    }
}

// One ball's leaves all look away from its middle.
TEST(Foliage, IsLitAsTheClumpsThatItFallsInto) {
    scene::TreeParameters p;
    p.tree_habit = static_cast<float>(habit_named("oak"));
    const TreeSkeleton skeleton = skeleton_of_species(form_of(p, Rank::First), base::Seed{7});
    glm::vec3 low{1.0e6F};
    glm::vec3 high{-1.0e6F};
    for (const Site& site : skeleton.sites) {
        low = glm::min(low, site.at_m);
        high = glm::max(high, site.at_m);
    }
    const scene::Leaves leaves = make_foliage(skeleton, {}, base::Seed{3});
    float sum = 0;
    float inward = 0;
    for (const scene::Leaves::Vertex& vertex : leaves.vertices) {
        const glm::vec3 out = glm::normalize((vertex.site_m - 0.5F * (low + high)) / (0.5F * (high - low)));
        const float cosine = glm::dot(vertex.normal, out);
        sum += cosine;
        if (cosine < 0.7F) ++inward;
    }
    const auto count = static_cast<float>(leaves.vertices.size());
    EXPECT_GT(sum / count, 0.5F) << "the crown is round all the same";
    EXPECT_GT(inward / count, 0.08F) << "the sides of clumps that face one another";
}

TEST(SprayTwigs, AreNoneOfSingleLeaves) {
    EXPECT_TRUE(leaf_shape(LeafKind::Ovate).twig_foot.empty());
    EXPECT_TRUE(spray_shape(LeafKind::Needles).twig_foot.empty());
}

TEST(SprayTwigs, BearAFlowerOnAGreyStemFromItsLimb) {
    const LeafShape& shape = spray_shape(LeafKind::Ovate);
    scene::Leaves leaves;
    BladeShape disc;
    disc.is_disc = true;
    disc.twig_m = {1, 2, 3};
    scene::Leaves::Vertex common;
    common.colour = {0.8F, 0.1F, 0.5F};
    add_blade(leaves, shape, disc, common);
    for (const auto& vertex : leaves.vertices) EXPECT_LT(glm::length(vertex.corner_m), 1.0F);
    const auto& left = leaves.vertices[shape.twig_foot[0]];
    const auto& right = leaves.vertices[shape.twig_foot[1]];
    EXPECT_LT(glm::distance(0.5F * (left.site_m + right.site_m), disc.twig_m), 1.0e-4F);
    EXPECT_GT(glm::distance(left.site_m, right.site_m), 1.0e-4F) << "a stem without a width is not drawn";
    EXPECT_EQ(left.colour.r, left.colour.g);
    EXPECT_LT(left.colour.g, 0.1F);
    EXPECT_GT(leaves.vertices.front().colour.r, 0.7F) << "the flower keeps its colour";
}

// The thinnest limbs are not drawn: what stood on them would float about the crown.
TEST(Foliage, StandsNoFartherFromDrawnWoodThanItMay) {
    for (const char* kind : {"elm", "oak", "birch", "fir"}) {
        scene::TreeParameters p;
        p.tree_habit = static_cast<float>(habit_named(kind));
        p.tree_blossom = 0.5F;
        const Form form = form_of(p, Rank::First);
        const scene::Species species = make_species(form, base::Seed{7});
        const mesh::Nearness wood(species.wood.front().mesh);
        float farthest_m = 0;
        for (std::size_t v = 0; v < species.leaves.vertices.size(); v += 7)
            farthest_m = std::max(farthest_m, wood.distance_m(species.leaves.vertices[v].site_m));
        // A little more, for the limb is looked for with some slack.
        EXPECT_LE(farthest_m, 1.25F * farthest_leaf_m(species.height_m)) << kind;
    }
}

}  // namespace
}  // namespace quadrat::synthesis::trees
