// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/year.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "genome/parameter_ids.hpp"
#include "genome/season.hpp"
#include "scene/tree_parameters.hpp"
#include "synthesis/trees/form.hpp"
#include "synthesis/trees/species.hpp"
#include "unit/synthesis/scenes.hpp"

namespace quadrat::synthesis::trees {
namespace {

float share_of(const std::vector<Organ>& organs, Organ organ) {
    return static_cast<float>(std::ranges::count(organs, organ)) / static_cast<float>(organs.size());
}

TEST(Year, OpensTurnsAndDropsWhatABudBears) {
    const auto in = [](float season) { return organs_in({season, 1, 0.3F}); };
    const std::vector<Organ> spring = in(0), summer = in(kMidsummer), autumn = in(2 * kMidsummer), winter = in(1);
    for (const auto* organs : {&spring, &summer, &autumn, &winter}) ASSERT_EQ(organs->size(), std::size_t{kBuds});
    EXPECT_NEAR(share_of(spring, Organ::Flower), 0.3F, 0.01F);
    EXPECT_GT(share_of(spring, Organ::YoungLeaf), 0.3F);
    EXPECT_GT(share_of(spring, Organ::None), 0.1F) << "some have not opened";
    EXPECT_EQ(share_of(summer, Organ::Leaf), 1);
    EXPECT_GT(share_of(autumn, Organ::TurnedLeaf), 0.7F);
    EXPECT_LT(share_of(autumn, Organ::None), 0.1F);
    EXPECT_GT(share_of(winter, Organ::None), 0.95F);
    EXPECT_GT(share_of(winter, Organ::TurnedLeaf), 0.005F) << "a few hang on";
}

TEST(Year, OfAnEvergreenIsAllLeavesButForItsYoungest) {
    for (const float season : {0.0F, kMidsummer, 0.7F, 1.0F})
        EXPECT_EQ(share_of(organs_in({season, 0, 0.5F}), Organ::Leaf), 1) << season;
    EXPECT_NEAR(share_of(organs_in({1, 0.1F, 0}), Organ::Leaf), 0.9F, 0.01F);
}

TEST(Year, IsTheSameBudsYear) {
    // What has fallen stays fallen, what has opened stays open: the same derivation, so many steps on.
    const auto gone = [](const std::vector<Organ>& organs, std::size_t i) { return organs[i] == Organ::None; };
    std::vector<Organ> before = organs_in({0, 1, 0.2F});
    for (int step = 1; step <= 15; ++step) {
        const float season = static_cast<float>(step) / 15;
        const std::vector<Organ> now = organs_in({season, 1, 0.2F});
        for (std::size_t i = 0; i < now.size(); ++i) {
            if (season < kMidsummer + 0.01F) {
                EXPECT_FALSE(gone(now, i) && !gone(before, i)) << step;
            } else {
                EXPECT_FALSE(!gone(now, i) && gone(before, i)) << step;
            }
        }
        before = now;
    }
}

scene::TreeParameters oak_in(float season) {
    scene::TreeParameters p;
    p.tree_habit = static_cast<float>(habit_named("oak"));
    p.tree_season = season;
    return p;
}

scene::Species species_in(float season) { return make_species(form_of(oak_in(season), Rank::First), base::Seed{7}); }

TEST(Year, ChangesATreesLeavesAndNotTheTree) {
    const TreeSkeleton grown = skeleton_of_species(form_of(oak_in(kMidsummer), Rank::First), base::Seed{7});
    const scene::Species summer = species_in(kMidsummer);
    for (const float season : {0.0F, 2 * kMidsummer, 1.0F}) {
        const TreeSkeleton other = skeleton_of_species(form_of(oak_in(season), Rank::First), base::Seed{7});
        ASSERT_EQ(other.limbs.size(), grown.limbs.size());
        for (std::size_t i = 0; i < grown.limbs.size(); ++i)
            ASSERT_EQ(other.limbs[i].nodes.back().at_m, grown.limbs[i].nodes.back().at_m);
        const scene::Species species = species_in(season);
        EXPECT_EQ(species.height_m, summer.height_m);
        EXPECT_EQ(species.crown_radius_m, summer.crown_radius_m);
        EXPECT_EQ(species.trunk_radius_m, summer.trunk_radius_m);
    }
    const auto area_m2 = [](const scene::Leaves& leaves) {
        float sum = 0;
        for (std::size_t i = 0; i + 2 < leaves.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) { return leaves.vertices[leaves.indices[i + k]].corner_m; };
            sum += 0.5F * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
        }
        return sum;
    };
    EXPECT_LT(area_m2(species_in(1).leaves), 0.45F * area_m2(summer.leaves)) << "twigs are thin";
    const auto redness = [](const scene::Species& species) {
        glm::vec3 sum{0};
        for (const scene::Leaves::Vertex& v : species.leaves.vertices) sum += v.colour;
        return sum.r / sum.g;
    };
    EXPECT_GT(redness(species_in(2 * kMidsummer)), 1.5F * redness(summer));
}

TEST(Year, MovesNoPlantOfALandscape) {
    genome::Recipe recipe = genome::random_recipe(base::Seed{41});
    recipe.values.set(genome::ParameterId::topiary_shape, 0);
    recipe.values.set(genome::ParameterId::settle_age, -1);
    recipe.values.set(genome::ParameterId::ground_snow_line, 2.5F);
    const auto places = [&](float season) {
        const scene::Scene scene = test_scenes::grow(genome::in_season(recipe, season));
        std::vector<glm::vec3> trees;
        for (const scene::Plant& plant : scene.plants)
            if (scene.flora->species[plant.species].storey == scene::Storey::Tree) trees.push_back(plant.root_m);
        return trees;
    };
    const std::vector<glm::vec3> summer = places(kMidsummer);
    ASSERT_FALSE(summer.empty());
    EXPECT_EQ(places(2 * kMidsummer), summer);
    EXPECT_EQ(places(1), summer);
}

TEST(Year, LeavesAMidsummerMeadowAsItIs) {
    const Meadow meadow = meadow_in(kMidsummer);
    EXPECT_EQ(meadow.dryness, 0);
    EXPECT_EQ(meadow.height, 1);
    EXPECT_EQ(meadow.flowers, 1);
    EXPECT_EQ(meadow.withered, 0);
    EXPECT_EQ(meadow_in(1).flowers, 0);
    EXPECT_GT(meadow_in(0.99F).dryness, meadow_in(0.7F).dryness);
}

}  // namespace
}  // namespace quadrat::synthesis::trees
