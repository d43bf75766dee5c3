// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/planting.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>

namespace quadrat::synthesis {
namespace {

constexpr int kSamples = 257;
constexpr float kCell_m = 2;

// Land 512 m wide whose height follows from the place.
template <typename Height>
scene::Land land_of(const Height& height_m) {
    scene::Land land;
    land.cell_m = kCell_m;
    land.height_m = mesh::Field(kSamples, kSamples);
    for (int row = 0; row < kSamples; ++row)
        for (int column = 0; column < kSamples; ++column)
            land.height_m.at(column, row) = height_m(kCell_m * static_cast<float>(column - kSamples / 2),
                                                     kCell_m * static_cast<float>(row - kSamples / 2));
    land.albedo = scene::GroundColours(mesh::Image(64, 64, 4));
    return land;
}

scene::Species tree() {
    scene::Species species;
    species.crown_radius_m = 2.5F;
    species.trunk_radius_m = 0.25F;
    species.moisture = 0.4F;
    species.moisture_width = 1.5F;
    return species;
}

scene::Flora wood_of(const scene::Species& species) {
    scene::Flora flora;
    flora.species = {species};
    flora.spacing_m = 7;
    flora.stand.grove_contrast = 0;
    flora.stand.clearings = 0;
    return flora;
}

// At the southern edge, looking away from it.
FlightPlan aside() { return {{{{0, 300}, {0, 1}}}}; }

std::size_t count_if(const std::vector<scene::Plant>& plants, auto is_there) {
    return static_cast<std::size_t>(
        std::ranges::count_if(plants, [&](const scene::Plant& p) { return is_there(p.root_m); }));
}

std::vector<scene::Plant> planted(const scene::Land& land, const scene::Flora& flora) {
    PlantingBudget all;
    all.trees = 100'000;
    return plant_land(land, flora, aside(), base::Seed{5}, all);
}

TEST(Planting, FollowsTheMoistureThatASpeciesLikes) {
    scene::Land land = land_of([](float, float) { return 30.0F; });
    mesh::Image ground(64, 64, 4);
    for (int y = 0; y < 64; ++y)
        for (int x = 32; x < 64; ++x) ground.pixel(x, y)[3] = 255;
    land.albedo = scene::GroundColours(ground);
    scene::Species willow = tree();
    willow.moisture = 0.95F;
    willow.moisture_width = 0.4F;
    scene::Species acacia = tree();
    acacia.moisture = 0.3F;
    acacia.moisture_width = 0.4F;
    const auto east = [](const glm::vec3& at) { return at.x > 8; };
    const auto west = [](const glm::vec3& at) { return at.x < -8; };
    const auto wet = planted(land, wood_of(willow));
    const auto dry = planted(land, wood_of(acacia));
    EXPECT_GT(count_if(wet, east), 400U);
    EXPECT_LT(count_if(wet, west), count_if(wet, east) / 10);
    EXPECT_LT(count_if(dry, east), count_if(dry, west) / 10);
}

TEST(Planting, EndsAtTheTreelineAndAtTheShore) {
    const scene::Land ramp = land_of([](float x, float) { return 0.3F * (x + 60); });
    scene::Species species = tree();
    species.treeline_m = 60;
    for (const scene::Plant& plant : planted(ramp, wood_of(species))) {
        EXPECT_LT(plant.root_m.y, 60);
        EXPECT_GT(plant.root_m.y, 0.4F);
    }
    EXPECT_GT(planted(ramp, wood_of(species)).size(), 200U);
}

TEST(Planting, ThinsOutOnSteepSlopes) {
    const scene::Land fold = land_of([](float x, float) { return 20 + std::max(x, 0.0F) * 0.75F; });
    scene::Species species = tree();
    species.treeline_m = 1000;
    species.steepest_slope = 0.9F;
    const auto plants = planted(fold, wood_of(species));
    const auto level = count_if(plants, [](const glm::vec3& at) { return at.x < -8; });
    const auto steep = count_if(plants, [](const glm::vec3& at) { return at.x > 8; });
    EXPECT_GT(steep, 10U);
    EXPECT_LT(steep, (level * 9) / 10);
    scene::Species timid = species;
    timid.steepest_slope = 0.5F;
    EXPECT_EQ(count_if(planted(fold, wood_of(timid)), [](const glm::vec3& at) { return at.x > 8; }), 0U);
}

TEST(Planting, KeepsOffRoads) {
    scene::Land land = land_of([](float, float) { return 30.0F; });
    land.roads.push_back({{{0, 30, -250}, {0, 30, 250}}, 6, 0.1F});
    mesh::Field to_edge_m(kSamples, kSamples);
    for (int row = 0; row < kSamples; ++row)
        for (int column = 0; column < kSamples; ++column)
            to_edge_m.at(column, row) =
                std::min(std::abs(kCell_m * static_cast<float>(column - kSamples / 2)) - 3, scene::kFarFromRoads_m);
    land.kept_clear = scene::kept_clear_of(to_edge_m);
    const auto plants = planted(land, wood_of(tree()));
    EXPECT_GT(plants.size(), 800U);
    for (const scene::Plant& plant : plants) EXPECT_GT(std::abs(plant.root_m.x), 3.5F);
}

TEST(Planting, LetsTheYoungStandUnderTheOldButNoTrunksTouch) {
    scene::Flora flora = wood_of(tree());
    flora.stand.young_share = 0.5F;
    flora.stand.self_thinning = 1;
    const auto plants = planted(land_of([](float, float) { return 30.0F; }), flora);
    std::size_t beneath = 0;
    for (std::size_t i = 0; i < plants.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const float apart = glm::distance(plants[i].root_m, plants[k].root_m);
            ASSERT_GT(apart, 0.25F * (plants[i].scale + plants[k].scale));
            const bool are_unlike = (plants[i].scale < 0.7F) != (plants[k].scale < 0.7F);
            if (are_unlike && apart < 2.5F * std::max(plants[i].scale, plants[k].scale)) ++beneath;
            if (plants[i].scale > 0.7F && plants[k].scale > 0.7F) {
                ASSERT_GT(apart, 0.5F * 7);
            }
        }
    }
    EXPECT_GT(beneath, 30U);
}

TEST(Planting, LeavesClearingsOpenWhateverCouldGrowThere) {
    const scene::Land land = land_of([](float, float) { return 30.0F; });
    scene::Flora flora = wood_of(tree());
    const std::size_t closed = planted(land, flora).size();
    flora.stand.clearings = 0.5F;
    const std::size_t open = planted(land, flora).size();
    EXPECT_LT(open, closed * 7 / 10);
    EXPECT_GT(open, closed * 3 / 10);
}

TEST(Planting, IsTheSameOnAnyNumberOfThreads) {
    const scene::Land land = land_of([](float x, float z) { return 20 + 0.02F * x + 0.01F * z; });
    std::vector<scene::Plant> one;
    std::vector<scene::Plant> four;
    oneapi::tbb::task_arena(1).execute([&] { one = planted(land, wood_of(tree())); });
    oneapi::tbb::task_arena(4).execute([&] { four = planted(land, wood_of(tree())); });
    ASSERT_EQ(one.size(), four.size());
    EXPECT_EQ(std::memcmp(one.data(), four.data(), one.size() * sizeof(scene::Plant)), 0);
}

// Where snow lies a palm gives way to what bears frost.
TEST(Planting, KeepsPalmsOutOfTheFrost) {
    scene::Land land = land_of([](float, float z) { return z < 0 ? 60.0F : 20.0F; });
    land.snow_line_m = 40;
    scene::Species palm = tree();
    palm.is_tender = true;
    scene::Flora flora = wood_of(palm);
    flora.species.push_back(tree());
    const std::vector<scene::Plant> plants = planted(land, flora);
    const auto is_palm = [](const scene::Plant& p) { return p.species == 0; };
    const auto in_frost = [](const scene::Plant& p) { return p.root_m.y > 40; };
    std::size_t palms = 0;
    std::size_t frozen_palms = 0;
    std::size_t frozen_others = 0;
    for (const scene::Plant& p : plants) {
        palms += is_palm(p) ? 1 : 0;
        if (in_frost(p)) (is_palm(p) ? frozen_palms : frozen_others) += 1;
    }
    EXPECT_GT(palms, 200U);
    EXPECT_GT(frozen_others, 200U);
    EXPECT_LT(frozen_palms * 10, frozen_others);
}

}  // namespace
}  // namespace quadrat::synthesis
