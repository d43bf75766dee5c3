// SPDX-License-Identifier: Apache-2.0
// Trees whose buds compete for light, and what life does to trees of any grower.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "scene/tree_parameters.hpp"
#include "support/effort.hpp"
#include "synthesis/compose/neighbours.hpp"
#include "synthesis/trees/burden.hpp"
#include "synthesis/trees/form.hpp"
#include "synthesis/trees/growing_tree.hpp"
#include "synthesis/trees/hardship.hpp"
#include "synthesis/trees/self_organising.hpp"

namespace quadrat::synthesis::trees {
namespace {

TreeSkeleton alone(const SelfOrganisation& p, std::uint64_t seed) {
    const Seedling one;
    return grow_together(p, {&one, 1}, base::Seed{seed}).front();
}

SelfOrganisation of_years(int years) {
    SelfOrganisation p;
    p.years = years;
    return p;
}

voxels::ShadowGrid grid() { return voxels::ShadowGrid({}, {-20, 0, -20}, {40, 40, 40}); }

std::vector<voxels::ShadowGrid::Change> crown(const glm::vec3& middle, float radius, std::uint64_t seed) {
    std::vector<voxels::ShadowGrid::Change> leaves;
    base::RandomStream random{base::Seed{seed}};
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 way = glm::normalize(glm::vec3{random.normal(), random.normal(), random.normal()});
        leaves.push_back({middle + radius * std::cbrt(random.unit_f()) * way, true});
    }
    return leaves;
}

TEST(ShadowGrid, GivesNoBudMoreLightForANeighbour) {
    voxels::ShadowGrid before = grid();
    before.apply(crown({-4, 16, 0}, 6, 1));
    voxels::ShadowGrid after = before;
    after.apply(crown({5, 18, 2}, 6, 2));
    int darker = 0;
    base::RandomStream random{base::Seed{3}};
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 at{random.between(-19, 19), random.between(0, 38), random.between(-19, 19)};
        ASSERT_LE(after.light_at(at), before.light_at(at)) << at.x << " " << at.y << " " << at.z;
        darker += after.light_at(at) < before.light_at(at);
    }
    EXPECT_GT(darker, 2000);
}

TEST(ShadowGrid, IsAsItWasWhenWhatGrewHasFallen) {
    voxels::ShadowGrid changed = grid();
    const voxels::ShadowGrid bare = changed;
    std::vector<voxels::ShadowGrid::Change> leaves = crown({3, 12, -2}, 8, 4);
    changed.apply(leaves);
    std::ranges::reverse(leaves);
    for (voxels::ShadowGrid::Change& leaf : leaves) leaf.is_new = false;
    changed.apply(leaves);
    for (int x = -19; x < 20; ++x)
        for (int y = 0; y < 40; ++y)
            ASSERT_EQ(changed.light_at({x, y, 0.3F * static_cast<float>(x)}),
                      bare.light_at({x, y, 0.3F * static_cast<float>(x)}));
}

TEST(ShadowGrid, IsDarkUnderARoofAndLitBesideACrown) {
    voxels::ShadowGrid one = grid();
    one.apply(crown({0, 24, 0}, 7, 5));
    voxels::ShadowGrid roof = grid();
    for (int x = -12; x <= 12; x += 8)
        for (int z = -12; z <= 12; z += 8) roof.apply(crown({x, 24, z}, 7, 5));
    const glm::vec3 low{9, 6, 0};
    EXPECT_GT(one.light_at(low), 0.75F);
    EXPECT_LT(roof.light_at(low), 0.85F * one.light_at(low));
    EXPECT_LT(roof.light_at({0, 6, 0}), 0.7F);
    EXPECT_GT(one.way_to_light({6, 20, 0}).x, 0) << "away from the crown";
}

// The whole stand, of which only one tree is looked at: with neighbours it has no more leaves than without.
TEST(SelfOrganised, HasFewerLeavesAmongNeighbours) {
    const SelfOrganisation p = of_years(16);
    for (std::uint64_t seed = 1; seed <= tests::of(6U); ++seed) {
        const std::vector<Seedling> two{{{0, 0}, {}}, {{6, 0}, {}}};
        const TreeSkeleton lone = grow_together(p, {two.data(), 1}, base::Seed{seed}).front();
        const TreeSkeleton shaded = grow_together(p, two, base::Seed{seed}).front();
        EXPECT_LT(shaded.sites.size(), lone.sites.size());
        EXPECT_LT(shaded.high_m.x, lone.high_m.x) << "it grows into its neighbour";
    }
}

bool are_same(const TreeSkeleton& a, const TreeSkeleton& b) {
    if (a.limbs.size() != b.limbs.size() || a.sites.size() != b.sites.size()) return false;
    for (std::size_t l = 0; l < a.limbs.size(); ++l) {
        if (a.limbs[l].nodes.size() != b.limbs[l].nodes.size()) return false;
        for (std::size_t i = 0; i < a.limbs[l].nodes.size(); ++i)
            if (a.limbs[l].nodes[i].at_m != b.limbs[l].nodes[i].at_m) return false;
    }
    return true;
}

TEST(SelfOrganised, StandsAreTheSameOnAnyNumberOfThreads) {
    const std::vector<Seedling> seedlings = stand_of_seedlings(12, base::Seed{4});
    const SelfOrganisation p = of_years(14);
    std::vector<TreeSkeleton> first;
    for (const std::size_t threads : {1U, 2U, 5U}) {
        const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism, threads);
        std::vector<TreeSkeleton> stand = grow_together(p, seedlings, base::Seed{4});
        if (first.empty())
            first = std::move(stand);
        else
            for (std::size_t i = 0; i < first.size(); ++i) EXPECT_TRUE(are_same(first[i], stand[i])) << threads;
    }
}

TEST(SelfOrganised, NoLimbComesToTheGroundAndEachBeginsOnItsBearer) {
    for (std::uint64_t seed = 1; seed <= tests::of(8U); ++seed) {
        SelfOrganisation p = of_years(18);
        p.limb_rise = -0.3F;
        const TreeSkeleton tree = alone(p, seed);
        ASSERT_GT(tree.limbs.size(), 30U);
        for (std::size_t l = 0; l < tree.limbs.size(); ++l) {
            const Limb& limb = tree.limbs[l];
            ASSERT_GE(limb.nodes.size(), 2U);
            ASSERT_LT(limb.parent, static_cast<int>(l));
            if (limb.parent >= 0) {
                EXPECT_EQ(limb.nodes.front().at_m, tree.limbs[limb.parent].nodes[limb.parent_node].at_m);
            }
            for (std::size_t i = 1; i < limb.nodes.size(); ++i) EXPECT_GT(limb.nodes[i].at_m.y, 0);
        }
        for (const Site& site : tree.sites) {
            ASSERT_LT(site.limb, static_cast<int>(tree.limbs.size()));
            ASSERT_LT(site.node, static_cast<int>(tree.limbs[site.limb].nodes.size()));
        }
    }
}

TEST(SelfOrganised, KeepsItsBudgetOfBuds) {
    SelfOrganisation few = of_years(40);
    few.most_buds = 600;
    const TreeSkeleton tree = alone(few, 2);
    EXPECT_LT(tree.sites.size(), 2000U);
    EXPECT_FALSE(tree.sites.empty()) << "a tree that has all its buds keeps its leaves";
}

// Radii by the pipe model: r to the power n is the sum over what a node bears, and its own wood.
TEST(SelfOrganised, RadiiFollowThePipeModel) {
    TreeSkeleton tree = alone(of_years(18), 3);
    PipeModel pipes;
    pipes.least_radius_m = 0;
    set_pipe_radii(tree, pipes);
    std::vector<std::vector<double>> borne(tree.limbs.size());
    for (std::size_t l = 0; l < tree.limbs.size(); ++l) borne[l].assign(tree.limbs[l].nodes.size(), 0.0);
    for (std::size_t l = tree.limbs.size(); l-- > 0;) {
        const Limb& limb = tree.limbs[l];
        const auto power = [&](std::size_t i) { return std::pow(limb.nodes[i].radius_m, pipes.exponent); };
        // The first node is drawn as thick as the limb goes on, but never as thick as its bearer.
        for (std::size_t i = 1; i + 1 < limb.nodes.size(); ++i) {
            EXPECT_GE(power(i) * 1.001, power(i + 1) + borne[l][i]);
            EXPECT_LT(power(i), power(i + 1) + borne[l][i] + 2e-3 * std::pow(pipes.trunk_radius_m, pipes.exponent));
        }
        if (limb.parent >= 0 && limb.nodes.size() > 1) borne[limb.parent][limb.parent_node] += power(1);
    }
}

// How high the crown is to how wide, and where it begins.
struct Crown {
    float height_to_width, base;
};
Crown crown_of(const TreeSkeleton& tree) {
    std::vector<float> up;
    float wide = 0;
    for (const Site& site : tree.sites) {
        up.push_back(site.at_m.y);
        wide += std::hypot(site.at_m.x, site.at_m.z) / static_cast<float>(tree.sites.size());
    }
    std::ranges::sort(up);
    const float low = up[up.size() / 10];
    const float high = up[up.size() - 1 - up.size() / 50];
    return {(high - low) / (3 * wide), low / high};
}

TEST(SelfOrganised, ALoneTreeIsRoundAndOneInAStandIsTallAndBareBelow) {
    for (const char* name : {"field oak", "beech", "mountain pine"}) {
        SCOPED_TRACE(name);
        const SelfOrganisation& p = kind(habit_named(name)).growth;
        const Crown lone = crown_of(alone(p, 5));
        const std::vector<TreeSkeleton> stand =
            grow_together(p, stand_of_seedlings(0.8F * p.apart, base::Seed{5}), base::Seed{5});
        const TreeSkeleton& middle = stand[12];
        const Crown among = crown_of(middle);
        EXPECT_GT(among.base, lone.base + 0.12F) << "bare below";
        const float lone_wide = alone(p, 5).high_m.x - alone(p, 5).low_m.x;
        EXPECT_LT(middle.high_m.x - middle.low_m.x, 0.8F * lone_wide);
        // As high as wide, nearly: a ball.
        EXPECT_GT(lone.height_to_width, 0.4F);
        EXPECT_LT(lone.height_to_width, 1.3F);
        glm::vec3 mean{0};
        for (const Site& site : stand[14].sites) mean += site.at_m / static_cast<float>(stand[14].sites.size());
        EXPECT_GT(mean.x, 1.0F) << "outward at the edge";
    }
}

TEST(SelfOrganised, WindLeavesTheFarSide) {
    SelfOrganisation p = of_years(18);
    const auto side = [](const TreeSkeleton& tree) {
        float mean = 0;
        for (const Site& site : tree.sites) mean += site.at_m.x / static_cast<float>(tree.sites.size());
        return mean;
    };
    float still = 0;
    float blown = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        p.upwind = {0, 0, 0};
        still += side(alone(p, seed));
        p.upwind = {-0.9F, 0, 0};
        blown += side(alone(p, seed));
    }
    EXPECT_GT(blown, still + 8);
}

TreeSkeleton any_tree() {
    Form form;
    form.habit = habit_named("oak");
    form.wind_crown = form.sag = form.straightening = form.bareness = 0;
    return grow_skeleton(form, base::Seed{6});
}

TEST(Burden, AtTheFootIsAllThatStandsOnIt) {
    const TreeSkeleton tree = any_tree();
    const auto burdens = burdens_of(tree);
    double wood = 0;
    for (const Limb& limb : tree.limbs) {
        for (std::size_t i = 1; i < limb.nodes.size(); ++i) {
            const double r = 0.5 * (limb.nodes[i].radius_m + limb.nodes[i - 1].radius_m);
            wood += 3.14159265 * r * r * glm::distance(limb.nodes[i].at_m, limb.nodes[i - 1].at_m);
        }
    }
    EXPECT_NEAR(burdens.front().front().weight, 1.25 * wood, 0.01 * wood);
    for (std::size_t l = 0; l < tree.limbs.size(); ++l)
        for (std::size_t i = 1; i < tree.limbs[l].nodes.size(); ++i)
            EXPECT_LE(burdens[l][i].weight, burdens[l][i - 1].weight * 1.0001F) << "more than what it hangs on";
}

TEST(Burden, OfALevelLimbHangsHalfWayOut) {
    TreeSkeleton tree;
    tree.limbs.resize(1);
    tree.limbs[0].nodes = {{{0, 3, 0}, 0.1F}, {{2, 3, 0}, 0.1F}, {{4, 3, 0}, 0.1F}};
    measure(tree);
    EXPECT_NEAR(burdens_of(tree)[0][0].lever_m, 2, 1e-4);
    EXPECT_NEAR(burdens_of(tree)[0][1].lever_m, 1, 1e-4);
    EXPECT_EQ(burdens_of(tree)[0][2].weight, 0);
}

float mean_height(const TreeSkeleton& tree) {
    float sum = 0;
    for (const Site& site : tree.sites) sum += site.at_m.y;
    return sum / static_cast<float>(tree.sites.size());
}

TEST(Wood, SagsUnderItsLoadAndItsEndsTurnUpAgainWithAge) {
    const TreeSkeleton straight = any_tree();
    TreeSkeleton sagged = straight;
    bend(sagged, {.sag = 1});
    TreeSkeleton aged = straight;
    bend(aged, {.sag = 1, .straightening = 1});
    EXPECT_LT(mean_height(sagged), mean_height(straight) - 0.1F);
    EXPECT_GT(mean_height(aged), mean_height(sagged) + 0.03F);
}

TEST(Wind, MakesACrownOneSidedAndLeavesItsStem) {
    TreeSkeleton tree = any_tree();
    const TreeSkeleton before = tree;
    face_wind(tree, {1, 0, 0}, base::Seed{1});
    const auto reach = [](const TreeSkeleton& t) {
        float most = 0;
        for (const Site& site : t.sites) most = std::max(most, -site.at_m.x);
        return most;
    };
    EXPECT_LT(reach(tree), 0.6F * reach(before));
    EXPECT_GT(tree.high_m.x, before.high_m.x);
    EXPECT_EQ(tree.limbs.front().nodes.front().at_m, before.limbs.front().nodes.front().at_m);
    EXPECT_LT(tree.limbs.size(), before.limbs.size());
    EXPECT_EQ(tree.limbs.front().nodes.size(), before.limbs.front().nodes.size());
}

TEST(Shade, FellsWhatTheCrownStandsOverAndNeverAll) {
    Form form;
    form.habit = habit_named("lime");
    TreeSkeleton tree = grow_skeleton(form, base::Seed{6});
    stretch(tree, glm::vec3{1 / tree.high_m.y}, 1);
    measure(tree);
    const std::size_t whole = tree.sites.size();
    TreeSkeleton shed = tree;
    shed_shaded(shed, 0);
    EXPECT_EQ(shed.sites.size(), whole);
    std::size_t left = whole;
    for (const float share : {0.4F, 0.6F, 0.8F}) {
        shed = tree;
        shed_shaded(shed, share);
        EXPECT_LE(shed.sites.size(), left);
        EXPECT_GT(shed.sites.size(), whole / 8);
        left = shed.sites.size();
    }
    EXPECT_LT(left, whole);
    EXPECT_GT(mean_height(shed), mean_height(tree)) << "what falls is below";
}

TEST(Shade, ThinsLeavesWhereItIsDarkOrFillsTheCrown) {
    Form form;
    form.habit = habit_named("lime");
    TreeSkeleton tree = grow_skeleton(form, base::Seed{6});
    stretch(tree, glm::vec3{1 / tree.high_m.y}, 1);
    measure(tree);
    const auto mean = [](const TreeSkeleton& t) {
        float height = 0;
        float all = 0;
        for (const Site& site : t.sites) {
            EXPECT_GE(site.weight, 0);
            height += site.weight * site.at_m.y;
            all += site.weight;
        }
        return height / all;
    };
    TreeSkeleton light = tree;
    set_leaves_by_light(light, -1);
    TreeSkeleton shade = tree;
    set_leaves_by_light(shade, 1);
    EXPECT_GT(mean(light), mean(tree) + 0.005F);
    EXPECT_LT(mean(shade), mean(tree) - 0.005F);
}

scene::Flora flora_of_forms() {
    scene::Flora flora;
    flora.species.resize(3);
    for (scene::Species& species : flora.species) species.crown_radius_m = 4;
    flora.species[0].in_stand = 1;
    flora.species[0].at_edge = 2;
    flora.species[1].is_form = flora.species[2].is_form = true;
    return flora;
}

TEST(Neighbours, MakeTheMiddleBareTheEdgeOpenAndLeaveTheLoneOneRound) {
    std::vector<synthesis::Candidate> trees;
    for (int z = 0; z < 5; ++z)
        for (int x = 0; x < 5; ++x) {
            synthesis::Candidate c;
            c.at_m = 6.0F * glm::vec2{x, z};
            c.mark = 0.5F;
            trees.push_back(c);
        }
    synthesis::Candidate far;
    far.at_m = {200, 0};
    far.mark = 0.5F;
    trees.push_back(far);
    grow_among_neighbours(trees, flora_of_forms());
    EXPECT_EQ(trees[12].species, 1U);
    EXPECT_EQ(trees.back().species, 0U);
    const std::size_t west = 10;
    const std::size_t north = 2;
    ASSERT_EQ(trees[west].species, 2U);
    ASSERT_EQ(trees[north].species, 2U);
    // Where the form's +x comes to lie: as the renderer turns it.
    const auto open = [&](std::size_t i) {
        return glm::vec2{std::cos(*trees[i].yaw_rad), -std::sin(*trees[i].yaw_rad)};
    };
    EXPECT_LT(open(west).x, -0.9F);
    EXPECT_LT(open(north).y, -0.9F);
}

// Whatever wind and hunger genes ask for together: a tree that dies of them would be none.
TEST(OrganisedTrees, LiveUnderTheHarshestGenes) {
    for (int habit = 0; habit < kind_count(); ++habit) {
        if (kind(habit).grower != Grower::SelfOrganised) continue;
        for (const float wind : {0.0F, 1.0F})
            for (const float bearing : {0.0F, 1.0F})
                for (const float stems : {0.0F, 1.0F}) {
                    scene::TreeParameters p;
                    p.tree_habit = static_cast<float>(habit);
                    p.tree_wind_crown = wind;
                    p.tree_wind_lean = wind;
                    p.tree_shade_bearing = bearing;
                    p.tree_stems = stems;
                    p.tree_crowding = 1;
                    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                        const TreeSkeleton tree = grow_skeleton(form_of(p, Rank::First), base::Seed{seed});
                        EXPECT_GE(tree.limbs.size(), 20U) << kind(habit).name << " " << wind << " " << bearing;
                        EXPECT_GE(tree.sites.size(), 20U) << kind(habit).name << " " << wind << " " << bearing;
                    }
                }
    }
}

}  // namespace
}  // namespace quadrat::synthesis::trees
