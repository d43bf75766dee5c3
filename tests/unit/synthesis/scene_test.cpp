// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "genome/parameter_ids.hpp"
#include "scene/parameters.hpp"
#include "support/effort.hpp"
#include "synthesis/compose/track.hpp"
#include "unit/synthesis/scenes.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;
using test_scenes::grow;
using test_scenes::kCoarse;

bool are_same(const scene::Species& a, const scene::Species& b) {
    bool same = a.name == b.name && a.bark == b.bark && a.bark_colour == b.bark_colour &&
                a.bark_tile_m == b.bark_tile_m && a.treeline_m == b.treeline_m &&
                a.steepest_slope == b.steepest_slope && a.moisture == b.moisture && a.shade_liking == b.shade_liking &&
                a.density == b.density && a.share == b.share && a.wood.size() == b.wood.size() &&
                a.leaves.indices == b.leaves.indices && a.leaves.vertices.size() == b.leaves.vertices.size() &&
                a.height_m == b.height_m;
    for (std::size_t i = 0; same && i < a.wood.size(); ++i) same = a.wood[i].mesh == b.wood[i].mesh;
    return same && std::memcmp(a.leaves.vertices.data(), b.leaves.vertices.data(),
                               a.leaves.vertices.size() * sizeof(scene::Leaves::Vertex)) == 0;
}

bool are_same(const scene::Plant& a, const scene::Plant& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// By day with all its weather, by night, or in snow.
bool changes_a_sky(const genome::Parameter& parameter) {
    using P = genome::ParameterId;
    genome::ParameterValues day = test_scenes::everything();
    for (const P id : {P::mist_share, P::rain_share, P::bow_strength, P::air_preetham}) day.set(id, 0.4F);
    day.set(P::cloud_cover, 0.7F);
    day.set(P::sun_elevation_deg, 14);
    genome::ParameterValues night;
    night.set(P::night_share, 0.6F);
    genome::ParameterValues winter;
    winter.set(P::snowfall_share, 0.4F);
    for (const genome::ParameterValues& base : {day, night, winter}) {
        const auto grown_with = [&](float value) {
            genome::ParameterValues values = base;
            values.set(parameter.id, value);
            return grow_sky(scene::realise(values).sky, base::Seed{31});
        };
        if (!(grown_with(parameter.min) == grown_with(parameter.max))) return true;
    }
    return false;
}

bool are_same(const scene::Masses& a, const scene::Masses& b) {
    return a.mesh == b.mesh && a.colours == b.colours && a.claddings == b.claddings && a.lamps == b.lamps;
}

bool are_same(const scene::Settlement& a, const scene::Settlement& b) {
    const auto all_same = [](const std::vector<scene::Masses>& some, const std::vector<scene::Masses>& others) {
        return std::ranges::equal(some, others, [](const auto& one, const auto& two) { return are_same(one, two); });
    };
    const auto is_built_alike = [&](const scene::Building& one, const scene::Building& two) {
        return all_same(one.levels, two.levels) && one.chimneys_m == two.chimneys_m;
    };
    const auto stands_alike = [](const scene::House& one, const scene::House& two) {
        return one.building == two.building && one.foot_m == two.foot_m && one.yaw_rad == two.yaw_rad &&
               one.wall_tint == two.wall_tint && one.roof_tint == two.roof_tint && one.evening == two.evening &&
               one.plume == two.plume;
    };
    return std::ranges::equal(a.buildings, b.buildings, is_built_alike) &&
           std::ranges::equal(a.houses, b.houses, stands_alike) && all_same(a.bounds, b.bounds) &&
           a.gardens == b.gardens && a.fields == b.fields && a.lit_share == b.lit_share;
}

bool are_same(const scene::Land& a, const scene::Land& b) {
    return a.height_m == b.height_m && a.surround_m == b.surround_m && a.albedo == b.albedo && a.detail == b.detail &&
           a.water_m == b.water_m && a.fresh_water == b.fresh_water && a.shallow_colour == b.shallow_colour &&
           a.deep_colour == b.deep_colour && a.detail_tile_m == b.detail_tile_m && a.detail_slopes == b.detail_slopes &&
           a.kinds == b.kinds && a.surround_albedo == b.surround_albedo && a.stone.mesh == b.stone.mesh &&
           a.kept_clear == b.kept_clear && a.ripple == b.ripple && a.lichen == b.lichen &&
           are_same(a.settlement, b.settlement);
}

bool are_same(const scene::Flora& a, const scene::Flora& b) {
    bool same =
        a.species.size() == b.species.size() && a.spacing_m == b.spacing_m && a.stand == b.stand && a.cover == b.cover;
    for (std::size_t i = 0; same && i < a.species.size(); ++i) same = are_same(a.species[i], b.species[i]);
    return same;
}

bool are_same(const scene::Sward& a, const scene::Sward& b) {
    return std::ranges::equal(a.tufts, b.tufts, [](const scene::Tuft& one, const scene::Tuft& two) {
        return one.root_m == two.root_m && one.yaw_rad == two.yaw_rad && one.radius_m == two.radius_m &&
               one.height_m == two.height_m && one.sent == two.sent && one.lit == two.lit && one.kind == two.kind;
    });
}

bool are_same(const scene::Scene& a, const scene::Scene& b) {
    bool same = are_same(*a.flora, *b.flora) && are_same(*a.land, *b.land) && *a.sky == *b.sky &&
                a.light.ground == b.light.ground && are_same(a.sward, b.sward) && a.plants.size() == b.plants.size() &&
                a.track.cameras.size() == b.track.cameras.size();
    for (std::size_t i = 0; same && i < a.plants.size(); ++i) same = are_same(a.plants[i], b.plants[i]);
    for (std::size_t i = 0; same && i < a.track.cameras.size(); ++i)
        same = a.track.cameras[i].eye_m == b.track.cameras[i].eye_m &&
               a.track.cameras[i].target_m == b.track.cameras[i].target_m;
    return same;
}

TEST(Scene, IsTheSameBitForBitOnAnyNumberOfThreads) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        const scene::Fineness fineness{.land_samples = 257, .light_px = 128, .albedo_px = 256};
        oneapi::tbb::global_control threads(oneapi::tbb::global_control::max_allowed_parallelism, 5);
        scene::Scene one;
        scene::Scene five;
        oneapi::tbb::task_arena(1).execute([&] { one = grow(recipe, fineness); });
        oneapi::tbb::task_arena(5).execute([&] { five = grow(recipe, fineness); });
        EXPECT_TRUE(are_same(one, five)) << seed;
    }
}

TEST(Scene, OfAnyGenomeIsFiniteAndAPlaceOneCouldStandIn) {
    for (std::uint64_t seed = 0; seed < tests::sample_of(200U); ++seed) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        const scene::SceneParameters p = scene::realise(recipe.values);
        const scene::Land land = grow_land(p.land, recipe.seeds[genome::Aspect::Land], kCoarse);
        int dry = 0;
        for (const float h : land.height_m.samples) {
            ASSERT_TRUE(std::isfinite(h) && std::abs(h) < 1500) << seed;
            dry += h > 0;
        }
        EXPECT_GT(dry, static_cast<int>(land.height_m.samples.size()) / 6) << seed;
        for (const float h : land.surround_m.samples) ASSERT_TRUE(std::isfinite(h) && std::abs(h) < 2500) << seed;
    }
}

TEST(Scene, OfAnyGenomeKeepsItsPlantsOnDryLandAndApart) {
    for (std::uint64_t seed = 0; seed < tests::of(24U); ++seed) {
        const scene::Scene s = grow(genome::random_recipe(base::Seed{seed}));
        std::vector<const scene::Plant*> trees;
        for (const scene::Plant& plant : s.plants) {
            ASSERT_LT(plant.species, s.flora->species.size());
            ASSERT_TRUE(std::isfinite(plant.root_m.x + plant.root_m.y + plant.root_m.z + plant.sun + plant.scale));
            ASSERT_TRUE(plant.sun >= 0 && plant.sun <= 1);
            EXPECT_GT(plant.root_m.y, 0) << seed;
            EXPECT_EQ(scene::water_depth_m(*s.land, {plant.root_m.x, plant.root_m.z}), 0) << seed;
            EXPECT_NEAR(plant.root_m.y, scene::ground_height_m(*s.land, {plant.root_m.x, plant.root_m.z}), 1e-3);
            EXPECT_LE(std::max(std::abs(plant.root_m.x), std::abs(plant.root_m.z)), 0.5F * s.land->side_m());
            if (s.flora->species[plant.species].storey == scene::Storey::Tree) trees.push_back(&plant);
        }
        EXPECT_LE(trees.size(), 900U);
        for (std::size_t i = 0; i < trees.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                const float reach = s.flora->species[trees[i]->species].trunk_radius_m * trees[i]->scale +
                                    s.flora->species[trees[k]->species].trunk_radius_m * trees[k]->scale;
                ASSERT_GT(glm::distance(trees[i]->root_m, trees[k]->root_m), reach) << seed;
            }
        }
    }
}

TEST(Scene, SortsItsPlantsBySpecies) {
    const scene::Scene s = grow(genome::random_recipe(base::Seed{9}));
    ASSERT_GT(s.plants.size(), 100U);
    for (std::size_t i = 1; i < s.plants.size(); ++i) EXPECT_LE(s.plants[i - 1].species, s.plants[i].species);
}

TEST(Scene, FliesOverGroundAndWaterAllTheWayAndThroughNoCrown) {
    for (std::uint64_t seed = 0; seed < tests::of(24U); ++seed) {
        const scene::Scene s = grow(genome::random_recipe(base::Seed{seed}));
        for (float t = 0; t <= 0.5F * s.track.period_s; t += 0.25F) {
            const scene::Camera camera = scene::camera_at(s.track, t);
            const float ground_m = scene::ground_height_m(*s.land, {camera.eye_m.x, camera.eye_m.z});
            ASSERT_GE(camera.eye_m.y, ground_m + 1.7F) << seed << " at " << t;
            ASSERT_GE(camera.eye_m.y, 2.5F) << seed;
            for (const scene::Plant& plant : s.plants) {
                const scene::Species& species = s.flora->species[plant.species];
                if (species.storey != scene::Storey::Tree) continue;
                const float aside =
                    glm::length(glm::vec2{plant.root_m.x - camera.eye_m.x, plant.root_m.z - camera.eye_m.z});
                ASSERT_GT(aside, 0.8F * species.crown_radius_m * plant.scale) << seed;
            }
        }
    }
}

TEST(Scene, FliesTheSameWayInPlanOverEveryLandFromAPlaceThatSuitsIt) {
    // Lands without anything that a flight would turn to.
    const auto without_landmarks = [](std::uint64_t seed) {
        genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        recipe.values.set(genome::ParameterId::arch_share, -1);
        recipe.values.set(genome::ParameterId::site_share, -1);
        recipe.values.set(genome::ParameterId::settle_age, -1);
        return recipe;
    };
    const scene::Scene a = grow(without_landmarks(1));
    genome::Recipe other = without_landmarks(2);
    other.flight = genome::random_recipe(base::Seed{1}).flight;
    const scene::Scene b = grow(other);
    ASSERT_EQ(a.track.cameras.size(), b.track.cameras.size());
    const auto in_plan = [](const glm::vec3& m) { return glm::vec2{m.x, m.z}; };
    const glm::vec2 apart = in_plan(a.track.cameras[0].eye_m) - in_plan(b.track.cameras[0].eye_m);
    EXPECT_LT(glm::length(apart), 220);
    for (std::size_t i = 0; i < a.track.cameras.size(); ++i) {
        const scene::Camera& one = a.track.cameras[i];
        const scene::Camera& two = b.track.cameras[i];
        EXPECT_LT(glm::distance(in_plan(one.eye_m) - in_plan(two.eye_m), apart), 1e-3F);
        EXPECT_LT(glm::distance(in_plan(one.target_m) - in_plan(two.target_m), apart), 1e-3F);
    }
}

// A village, for the parameters that only show in one.
genome::ParameterValues a_village() {
    genome::ParameterValues values;
    values.set(genome::ParameterId::settle_age, 0.5F);
    values.set(genome::ParameterId::settle_fields, 0.4F);
    values.set(genome::ParameterId::climber_share, 0.6F);
    return values;
}

// With what grows only where it is asked for.
genome::ParameterValues all_plants() {
    genome::ParameterValues values = test_scenes::everything();
    values.set(genome::ParameterId::mushroom_rings, 0.9F);
    values.set(genome::ParameterId::topiary_shape, 2);
    return values;
}

// Open land, for what only shows on walls between fields and on rock in steps.
genome::ParameterValues land_with_walls_and_ledges() {
    genome::ParameterValues values;
    values.set(genome::ParameterId::wall_share, 0.9F);
    values.set(genome::ParameterId::ledge_share, 0.9F);
    return values;
}

TEST(Scene, ChangesWithEachOfTheParametersOfItsAspect) {
    const base::Seed seed{13};
    const scene::Fineness fineness{.land_samples = 129, .light_px = 64, .albedo_px = 64};
    const scene::Fineness finer{.land_samples = 257, .light_px = 64, .albedo_px = 64};
    const scene::SceneParameters plain = scene::realise(all_plants());
    const scene::Flora flora = grow_trees(plain.trees, seed);
    const scene::Land land = grow_land(plain.land, seed, fineness);
    const scene::Land village = grow_land(scene::realise(a_village()).land, seed, fineness);
    ASSERT_FALSE(village.settlement.is_empty());
    const scene::Land walled = grow_land(scene::realise(land_with_walls_and_ledges()).land, seed, fineness);
    const scene::Land fine_land = grow_land(plain.land, seed, finer);
    for (const genome::Parameter& parameter : genome::parameter_table()) {
        const bool is_peoples = parameter.name.starts_with("settle.") || parameter.name.starts_with("climber.");
        const bool is_wall = parameter.name.starts_with("wall.") || parameter.name.starts_with("ledge.");
        genome::ParameterValues values = is_peoples ? a_village()
                                         : is_wall  ? land_with_walls_and_ledges()
                                                    : all_plants();
        const bool is_high = values[parameter.id] > 0.5F * (parameter.min + parameter.max);
        values.set(parameter.id, is_high ? parameter.min : parameter.max);
        const scene::SceneParameters p = scene::realise(values);
        switch (parameter.aspect) {
            case genome::Aspect::Trees:
                EXPECT_FALSE(are_same(grow_trees(p.trees, seed), flora)) << parameter.name;
                break;
            case genome::Aspect::Land:
                if (is_peoples || is_wall) {
                    EXPECT_FALSE(are_same(grow_land(p.land, seed, fineness), is_wall ? walled : village))
                        << parameter.name;
                    break;
                }
                // What only the finest samples show is looked for there.
                EXPECT_FALSE(are_same(grow_land(p.land, seed, fineness), land) &&
                             are_same(grow_land(p.land, seed, finer), fine_land))
                    << parameter.name;
                break;
            case genome::Aspect::Sky:
                EXPECT_TRUE(changes_a_sky(parameter)) << parameter.name;
                break;
        }
    }
}

TEST(Land, ContinuesIntoItsSurroundWithoutAStep) {
    for (std::uint64_t seed = 0; seed < tests::of(20U); ++seed) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        const scene::Land land =
            grow_land(scene::realise(recipe.values).land, recipe.seeds[genome::Aspect::Land], kCoarse);
        const float half_m = 0.5F * land.side_m();
        const auto surround_m = [&](float x, float z) {
            const float half = 0.5F * static_cast<float>(land.surround_m.columns - 1);
            return mesh::sample(land.surround_m, x / land.surround_cell_m + half, z / land.surround_cell_m + half);
        };
        for (float along = -half_m; along <= half_m; along += land.cell_m) {
            for (const float side : {-half_m, half_m}) {
                EXPECT_NEAR(scene::ground_height_m(land, {along, side}), surround_m(along, side), 0.01F);
                EXPECT_NEAR(scene::ground_height_m(land, {side, along}), surround_m(side, along), 0.01F);
            }
        }
        for (float x = -half_m + 96; x < half_m - 96; x += 64)
            EXPECT_LT(surround_m(x, x), scene::ground_height_m(land, {x, x}) + 25) << seed;
    }
}

TEST(Sky, HasAUnitSunAboveTheHorizonAndFinitePositiveLight) {
    for (std::uint64_t seed = 0; seed < tests::of(24U); ++seed) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        const scene::Sky sky = grow_sky(scene::realise(recipe.values).sky, recipe.seeds[genome::Aspect::Sky]);
        EXPECT_NEAR(glm::length(sky.sun_direction), 1, 1e-5);
        EXPECT_GT(sky.sun_direction.y, 0);
        for (const glm::vec3& c : {sky.sunlight, sky.ambient.on({0, 1, 0}), sky.ambient.on({0, -1, 0}), sky.light_below,
                                   sky.haze_colour, sky.haze_sunward, sky.clouds[0].sunlit, sky.clouds[1].shaded}) {
            for (int i = 0; i < 3; ++i)
                ASSERT_TRUE(std::isfinite(c[i]) && c[i] > 0 && c[i] < 3) << seed << ": " << c[i] << " of " << i;
        }
    }
}

}  // namespace
