// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/planting.hpp"
#include "genome/parameter_ids.hpp"

#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <utility>

#include "synthesis/compose/site.hpp"
#include "synthesis/trees/form.hpp"
#include "unit/synthesis/scenes.hpp"

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
    return plant_land(land, flora, aside(), {}, base::Seed{5}, all);
}

TEST(Planting, LeavesBareStoneToTheFrugal) {
    scene::Land land = land_of([](float, float) { return 30.0F; });
    land.kinds = mesh::Image(kSamples, kSamples, 2);
    for (int row = 0; row < kSamples; ++row)
        for (int column = kSamples / 2; column < kSamples; ++column) land.kinds.pixel(column, row)[1] = 255;
    const auto east = [](const glm::vec3& at) { return at.x > 8; };
    const auto west = [](const glm::vec3& at) { return at.x < -8; };
    scene::Species pine = tree();
    pine.moisture = 0.2F;
    scene::Species birch = tree();
    birch.moisture = 0.6F;
    const auto pines = planted(land, wood_of(pine));
    const auto birches = planted(land, wood_of(birch));
    EXPECT_GT(count_if(birches, west), 400U);
    EXPECT_LT(count_if(birches, east), count_if(birches, west) / 3);
    EXPECT_GT(count_if(pines, east), 2 * count_if(birches, east));
}

TEST(Planting, ThinsOutAboveTheSnowLineUnlessAllLiesInSnow) {
    const auto slope = [](float x_m, float) { return 90 + 0.2F * x_m; };
    scene::Land land = land_of(slope);
    const auto high = [](const glm::vec3& at) { return at.y > 115; };
    land.snow_line_m = 90;
    const auto below = planted(land, wood_of(tree()));
    land.snow_line_m = 3;
    const auto white = planted(land, wood_of(tree()));
    EXPECT_GT(count_if(white, high), 200U);
    EXPECT_LT(count_if(below, high), count_if(white, high) / 5);
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

// Trees of a patch that has burnt are of an age: neighbours are alike in size, and some land is bare.
TEST(Planting, StandsInPatchesOfSeveralAgesWhereItBurns) {
    const scene::Land land = land_of([](float, float) { return 30.0F; });
    scene::Flora flora = wood_of(tree());
    flora.stand.young_share = 0;
    flora.stand.size_spread = 0;
    const std::size_t unburnt = planted(land, flora).size();
    flora.stand.fires = 0.7F;
    const auto plants = planted(land, flora);
    std::size_t small = 0;
    std::size_t old = 0;
    double apart = 0;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < plants.size(); ++i) {
        EXPECT_LE(plants[i].scale, 1.51F);
        small += plants[i].scale < 0.6F;
        old += plants[i].scale > 0.99F;
        for (std::size_t k = 0; k < i; ++k) {
            if (glm::distance(plants[i].root_m, plants[k].root_m) > 8) continue;
            apart += std::abs(plants[i].scale - plants[k].scale);
            ++pairs;
        }
    }
    EXPECT_GT(small, plants.size() / 10);
    EXPECT_GT(old, plants.size() / 8);
    EXPECT_LT(apart / static_cast<double>(pairs), 0.12);
    EXPECT_NE(plants.size(), unburnt);
}

// How unevenly trees lie: the spread of their numbers in squares of a clearing's size, to the mean.
double unevenness(const std::vector<scene::Plant>& plants, float side_m) {
    std::map<std::pair<int, int>, double> counts;
    const int squares = static_cast<int>(400 / side_m);
    for (int y = 0; y < squares; ++y)
        for (int x = 0; x < squares; ++x) counts[{x, y}] = 0;
    for (const scene::Plant& plant : plants) {
        const auto square = std::pair{static_cast<int>(std::floor((plant.root_m.x + 200) / side_m)),
                                      static_cast<int>(std::floor((plant.root_m.z + 200) / side_m))};
        if (counts.contains(square)) ++counts[square];
    }
    double sum = 0;
    double squared = 0;
    for (const auto& [square, count] : counts) {
        sum += count;
        squared += count * count;
    }
    const double mean = sum / static_cast<double>(counts.size());
    return std::sqrt(squared / static_cast<double>(counts.size()) - mean * mean) / mean;
}

TEST(Planting, ClearingsThatKeepOthersOffAreEvenlyStrewn) {
    const scene::Land land = land_of([](float, float) { return 30.0F; });
    scene::Flora flora = wood_of(tree());
    flora.stand.grove_m = 45;
    flora.stand.clearings = 0.4F;
    const auto by_chance = planted(land, flora);
    flora.stand.even_clearings = 1;
    const auto evenly = planted(land, flora);
    EXPECT_LT(unevenness(evenly, 50), 0.8 * unevenness(by_chance, 50));
    EXPECT_NEAR(static_cast<double>(evenly.size()) / static_cast<double>(by_chance.size()), 1, 0.35) << "as many";
}

TEST(Planting, GiantsStandSinglyAmongTheRest) {
    const scene::Land land = land_of([](float, float) { return 30.0F; });
    scene::Flora flora = wood_of(tree());
    flora.stand.grove_m = 60;
    flora.stand.size_spread = 0.1F;
    const auto count_giants = [&] {
        std::vector<glm::vec3> giants;
        for (const scene::Plant& plant : planted(land, flora))
            if (plant.scale > 1.55F) giants.push_back(plant.root_m);
        return giants;
    };
    EXPECT_LE(count_giants().size(), 1U) << "a hero at most";
    flora.stand.giants = 1;
    const std::vector<glm::vec3> giants = count_giants();
    EXPECT_GT(giants.size(), 12U);
    EXPECT_LT(giants.size(), planted(land, flora).size() / 5);
}

TEST(Planting, TakesAFormForItsKindAndNeverByItself) {
    scene::Flora flora = wood_of(tree());
    flora.species.resize(3, tree());
    flora.species[0].in_stand = 1;
    flora.species[0].at_edge = 2;
    flora.species[1].is_form = flora.species[2].is_form = true;
    flora.spacing_m = 5;
    const auto plants = planted(land_of([](float x, float) { return x < 0 ? -3.0F : 30.0F; }), flora);
    std::array<std::size_t, 3> of_form{};
    for (const scene::Plant& plant : plants) ++of_form.at(plant.species);
    EXPECT_GT(of_form[1], plants.size() / 8) << "in the middle";
    EXPECT_GT(of_form[2], plants.size() / 50) << "along the shore";
    flora.species[0].in_stand = flora.species[0].at_edge = -1;
    for (const scene::Plant& plant : planted(land_of([](float, float) { return 30.0F; }), flora))
        ASSERT_EQ(plant.species, 0U);
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

// An island's palms, cacti and firs: a third of the land each, where nothing but the zone tells them apart.
TEST(Planting, KeepsPalmsToTheBeachCactiToTheDesertAndFirsToTheGrass) {
    scene::Land land = land_of([](float, float z) { return 0.06F * (z + 200); });
    mesh::Image ground(64, 64, 4);
    const glm::u8vec3 grass{98, 128, 58};
    const glm::u8vec3 desert{190, 160, 118};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c) ground.pixel(x, y)[c] = (x < 32 ? grass : desert)[c];
    land.albedo = scene::GroundColours(ground);
    const auto of_kind = [](const char* name) {
        const trees::Kind& kind = trees::kind(trees::habit_named(name));
        scene::Species species = tree();
        species.shore_liking = kind.shore_liking;
        species.arid_liking = kind.arid_liking;
        return species;
    };
    scene::Flora flora = wood_of(of_kind("palm"));
    flora.species.push_back(of_kind("cactus"));
    flora.species.push_back(of_kind("fir"));
    const auto is_beach = [](const glm::vec3& at) { return at.y < 2; };
    const auto is_desert = [](const glm::vec3& at) { return at.y > 5 && at.x > 8; };
    const auto is_grass = [](const glm::vec3& at) { return at.y > 5 && at.x < -8; };
    const auto share = [&](std::uint32_t species, const auto& is_there) {
        double own = 0;
        double all = 0;
        for (const scene::Plant& plant : planted(land, flora)) {
            if (!is_there(plant.root_m)) continue;
            all += 1;
            own += plant.species == species ? 1 : 0;
        }
        EXPECT_GT(all, 40);
        return own / all;
    };
    EXPECT_GT(share(0, is_beach), 0.9);
    EXPECT_GT(share(1, is_desert), 0.9);
    EXPECT_GT(share(2, is_grass), 0.9);
    // Alone, a palm grows wherever one can.
    flora.species.resize(1);
    EXPECT_GT(share(0, is_desert), 0.99);
}

// The same of landscapes that are grown from genes, with the beaches, the dry and the green ground that these give
// them.
TEST(Planting, KeepsAnIslandsKindsToTheirZones) {
    using P = genome::ParameterId;
    const auto habit = [](const char* kind) { return static_cast<float>(trees::habit_named(kind)); };
    for (const std::uint64_t seed : {1U, 2U, 5U}) {
        genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        recipe.values = {};
        // Palms, and of what goes with them the cactus and the fir.
        for (const auto& [id, value] : std::initializer_list<std::pair<P, float>>{{P::tree_habit, habit("palm")},
                                                                                  {P::second_companion, 5},
                                                                                  {P::second_share, 0.9F},
                                                                                  {P::third_companion, 7},
                                                                                  {P::third_share, 1},
                                                                                  {P::tree_spacing_m, 8},
                                                                                  {P::land_relief_m, 70},
                                                                                  {P::land_sea_level, 0.45F},
                                                                                  {P::island_share, 0.55F},
                                                                                  {P::island_wave_m, 420},
                                                                                  {P::ground_country, 2},
                                                                                  {P::ground_chance, 0},
                                                                                  {P::ground_heath, 0},
                                                                                  {P::ground_beach, 1.8F},
                                                                                  {P::ground_moisture, 1},
                                                                                  {P::ground_lushness, 0.25F},
                                                                                  {P::ground_patch_m, 120},
                                                                                  {P::stand_clearings, 0}})
            recipe.values.set(id, value);
        const scene::Scene scene = test_scenes::grow(recipe, {257, 64, 512});
        const Zones zones(*scene.land);
        std::map<std::string, double> beach, desert, grass;
        double on_beach = 0, on_desert = 0, on_grass = 0;
        for (const scene::Plant& plant : scene.plants) {
            const scene::Species& species = scene.flora->species[plant.species];
            if (species.storey != scene::Storey::Tree) continue;
            const Zone zone = zones.at({plant.root_m.x, plant.root_m.z});
            const bool is_beach = zone.shore > 0.5F;
            const bool is_desert = !is_beach && zone.arid > 0.5F;
            (is_beach ? beach : is_desert ? desert : grass)[species.name] += 1;
            (is_beach ? on_beach : is_desert ? on_desert : on_grass) += 1;
        }
        EXPECT_GT(on_beach, 40) << seed;
        EXPECT_GT(on_desert, 100) << seed;
        EXPECT_GT(on_grass, 100) << seed;
        EXPECT_GT(beach["palm"] / on_beach, 0.9) << seed;
        EXPECT_GT(desert["cactus"] / on_desert, 0.6) << seed;
        EXPECT_GT(grass["fir"] / on_grass, 0.75) << seed;
    }
}

}  // namespace
}  // namespace quadrat::synthesis
