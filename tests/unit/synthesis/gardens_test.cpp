// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/gardens.hpp"
#include "scene/land_parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "synthesis/compose/planting.hpp"
#include "synthesis/grow.hpp"
#include "synthesis/houses/lanes.hpp"
#include "synthesis/trees/phyllotaxis.hpp"

namespace quadrat::synthesis {
namespace {

using scene::Bedded;

const scene::Land& village(float gardens) {
    const auto grown = [](float share) {
        scene::LandParameters p;
        p.land_relief_m = 60;
        p.land_sea_level = 0.1F;
        p.settle_age = 0.5F;
        p.settle_gardens = share;
        p.settle_density = 0.2F;
        return grow_land(p, base::Seed{24}, {.land_samples = 257, .light_px = 64, .albedo_px = 256});
    };
    static const scene::Land kMany = grown(1);
    static const scene::Land kFew = grown(0);
    return gardens > 0.5F ? kMany : kFew;
}

std::size_t count_of(const scene::Land& land, Bedded what) {
    return static_cast<std::size_t>(std::ranges::count_if(
        land.settlement.gardens, [what](const scene::GardenPlant& plant) { return plant.what == what; }));
}

TEST(Gardens, HoldEveryKindAndMoreWherePeopleGarden) {
    for (const Bedded what : {Bedded::FruitTree, Bedded::Bush, Bedded::Flower, Bedded::Vegetable}) {
        EXPECT_GT(count_of(village(1), what), 20U) << static_cast<int>(what);
        EXPECT_LT(3 * count_of(village(0), what), count_of(village(1), what)) << static_cast<int>(what);
    }
}

TEST(Gardens, KeepOffWallsLanesAndWater) {
    const scene::Land& land = village(1);
    for (const scene::GardenPlant& plant : land.settlement.gardens) {
        EXPECT_TRUE(houses::is_buildable(land, plant.at_m));
        for (const scene::House& house : land.settlement.houses)
            EXPECT_GT(scene::to_house_m(land.settlement.buildings[house.building], house, plant.at_m), 0.7F);
        for (const scene::Road& road : land.roads)
            for (const glm::vec3& p : road.line_m)
                EXPECT_GT(glm::distance(glm::vec2{p.x, p.z}, plant.at_m), 0.5F * road.width_m);
    }
}

TEST(Gardens, OrchardsLeaveTheirTreesRoom) {
    std::vector<glm::vec2> trees;
    for (const scene::GardenPlant& plant : village(1).settlement.gardens)
        if (plant.what == Bedded::FruitTree) trees.push_back(plant.at_m);
    for (std::size_t i = 0; i < trees.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) EXPECT_GE(glm::distance(trees[i], trees[k]), 3.2F);
}

// Of a bed, flower n + 1 is turned by the golden angle against flower n, seen from its middle.
TEST(Gardens, BedsAreLaidOutAsFloretsAre) {
    std::vector<glm::vec2> flowers;
    for (const scene::GardenPlant& plant : village(1).settlement.gardens)
        if (plant.what == Bedded::Flower) flowers.push_back(plant.at_m);
    int turned = 0;
    for (std::size_t i = 0; i + 2 < flowers.size(); ++i) {
        // The steps from flower to flower say where the middle is: it is the same for three in a row.
        for (int n = 1; n < 28; ++n) {
            const auto floret = [n](int k) { return trees::floret(n + k, 0.23F); };
            const glm::vec2 middle = flowers[i] - floret(0);
            if (glm::distance(middle + floret(1), flowers[i + 1]) < 1.0e-3F &&
                glm::distance(middle + floret(2), flowers[i + 2]) < 1.0e-3F) {
                ++turned;
                break;
            }
        }
    }
    EXPECT_GT(turned, static_cast<int>(flowers.size()) / 2);
}

TEST(Gardens, HaveClippedTreesInPairsWhereTheFloraHasThem) {
    std::vector<scene::GardenPlant> clipped;
    for (const scene::GardenPlant& plant : village(1).settlement.gardens)
        if (plant.what == Bedded::Topiary) clipped.push_back(plant);
    ASSERT_GT(clipped.size(), 10U);
    int paired = 0;
    for (std::size_t i = 0; i + 1 < clipped.size(); ++i)
        paired += std::abs(glm::distance(clipped[i].at_m, clipped[i + 1].at_m) - 3.4F) < 0.01F &&
                  clipped[i].height_m == clipped[i + 1].height_m;
    EXPECT_GT(paired, static_cast<int>(clipped.size()) / 3);
    scene::Flora flora;
    flora.species.resize(2);
    EXPECT_EQ(kind_for(flora, Bedded::Topiary), 2U) << "none";
    flora.species[1].name = "topiary";
    EXPECT_EQ(kind_for(flora, Bedded::Topiary), 1U);
}

scene::Species kind(const char* name, scene::Storey storey, float height_m, float crown_m) {
    scene::Species species;
    species.name = name;
    species.storey = storey;
    species.height_m = height_m;
    species.crown_radius_m = crown_m;
    species.trunk_radius_m = 0.02F * height_m;
    return species;
}

scene::Flora flora() {
    scene::Flora flora;
    flora.species = {kind("spire", scene::Storey::Tree, 20, 2), kind("round", scene::Storey::Tree, 9, 4),
                     kind("shrub", scene::Storey::Shrub, 1.4F, 0.8F), kind("fern", scene::Storey::Herb, 0.5F, 0.4F),
                     kind("flower", scene::Storey::Herb, 0.4F, 0.2F)};
    return flora;
}

TEST(Gardens, AreOfTheNearestKindsThatThereAre) {
    scene::Flora all = flora();
    EXPECT_EQ(kind_for(all, Bedded::FruitTree), 1U);
    EXPECT_EQ(kind_for(all, Bedded::Bush), 2U);
    EXPECT_EQ(kind_for(all, Bedded::Vegetable), 3U);
    EXPECT_EQ(kind_for(all, Bedded::Flower), 4U);
    all.species.resize(3);
    EXPECT_EQ(kind_for(all, Bedded::Flower), all.species.size()) << "none";
}

TEST(Gardens, ArePlantedWithTheRestAndWhatIsWildMakesWay) {
    const scene::Land& land = village(1);
    glm::vec2 middle{0};
    for (const scene::GardenPlant& plant : land.settlement.gardens)
        middle += plant.at_m / static_cast<float>(land.settlement.gardens.size());
    const FlightPlan flight{{{middle + glm::vec2{0, 70}, {0, -1}}}};
    const std::vector<scene::Plant> plants = plant_land(land, flora(), flight, {}, base::Seed{4});
    std::size_t fruit = 0;
    std::size_t beds = 0;
    for (const scene::GardenPlant& garden : land.settlement.gardens) {
        const auto is_it = [&](const scene::Plant& plant) {
            return plant.root_m.x == garden.at_m.x && plant.root_m.z == garden.at_m.y;
        };
        if (!std::ranges::any_of(plants, is_it)) continue;
        ++(garden.what == Bedded::FruitTree ? fruit : beds);
        if (garden.what != Bedded::FruitTree) continue;
        const auto crowds = [&](const scene::Plant& plant) {
            const float away_m = glm::distance(glm::vec2{plant.root_m.x, plant.root_m.z}, garden.at_m);
            return plant.species == 0 && away_m < 3.9F && plant.scale > 0;
        };
        EXPECT_FALSE(std::ranges::any_of(plants, crowds));
    }
    EXPECT_GT(fruit, 10U);
    EXPECT_GT(beds, 40U);
}

}  // namespace
}  // namespace quadrat::synthesis
