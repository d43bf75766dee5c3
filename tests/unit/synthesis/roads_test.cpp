// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/roads.hpp"
#include "scene/parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <map>

#include "genome/recipe.hpp"
#include "mesh/pieces.hpp"
#include "support/effort.hpp"
#include "synthesis/compose/track.hpp"
#include "synthesis/compose/view_merit.hpp"
#include "synthesis/grow.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

scene::Land settled(std::uint64_t seed, float road_share, float site_share) {
    const genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
    scene::SceneParameters p = scene::realise(recipe.values);
    p.land.road_share = road_share;
    p.land.site_share = site_share;
    p.land.settle_age = -1;
    p.land.ledge_share = -1;  // which would stand on the same ground
    return grow_land(p.land, recipe.seeds[genome::Aspect::Land],
                     {.land_samples = 257, .light_px = 64, .albedo_px = 64});
}

glm::vec2 plan(const glm::vec3& p) { return {p.x, p.z}; }

TEST(Roads, KeepTheirGradeAndStayOnDryLandOrFords) {
    int roads = 0;
    for (std::uint64_t seed = 0; seed < tests::of(60U); ++seed) {
        const scene::Land land = settled(seed, 1, -1);
        for (const scene::Road& road : land.roads) {
            ++roads;
            for (std::size_t i = 1; i < road.line_m.size(); ++i) {
                const float run_m = glm::length(plan(road.line_m[i]) - plan(road.line_m[i - 1]));
                EXPECT_LE(std::abs(road.line_m[i].y - road.line_m[i - 1].y), road.grade * run_m + 1e-3F) << seed;
                EXPECT_LT(run_m, 6.5F);
                EXPECT_LT(scene::water_depth_m(land, plan(road.line_m[i])), 1.3F) << seed;
            }
        }
    }
    EXPECT_GT(roads, tests::of(25));
}

// The ground itself, over ten metres: a wheel feels no more than the bound and what the land's samples round.
TEST(Roads, AreAsLevelAsTheySay) {
    int measured = 0;
    int steep = 0;
    for (std::uint64_t seed = 0; seed < tests::of(30U); ++seed) {
        const scene::Land land = settled(seed, 1, -1);
        for (const scene::Road& road : land.roads) {
            for (std::size_t i = 4; i < road.line_m.size(); i += 4) {
                const glm::vec2 a = plan(road.line_m[i - 4]);
                const glm::vec2 b = plan(road.line_m[i]);
                if (scene::water_depth_m(land, a) > 0 || scene::water_depth_m(land, b) > 0) continue;
                const float rise_m = std::abs(scene::ground_height_m(land, b) - scene::ground_height_m(land, a));
                ++measured;
                steep += rise_m > road.grade * 12.0F + 0.35F;
            }
        }
    }
    EXPECT_GT(measured, tests::of(500));
    EXPECT_LT(steep, measured / 50);
}

// A ridge right across the land, three times as steep as the road may be: it climbs aslant.
TEST(Roads, BendWhereTheStraightWayIsTooSteep) {
    mesh::Field ridge(257, 257);
    for (int y = 0; y < 257; ++y)
        for (int x = 0; x < 257; ++x) {
            const float z = 4.0F * static_cast<float>(y - 108);
            ridge.at(x, y) = 3 + 45 * std::exp(-z * z / (100.0F * 100.0F));
        }
    const mesh::Field before = ridge;
    const mesh::Field dry(257, 257, scene::kNoWater);
    const scene::Site beyond{{0, ridge.at(128, 64), -256}, 30};
    const auto roads = land::make_roads(ridge, dry, 4, beyond, {.width_m = 4, .grade = 0.1F}, base::Seed{3});
    ASSERT_EQ(roads.size(), 2U);
    float climbing_m = 0;
    float deepest_m = 0;
    for (std::size_t i = 1; i < roads[0].line_m.size(); ++i) {
        const glm::vec3& p = roads[0].line_m[i];
        if (std::abs(p.z + 80) < 150) climbing_m += glm::length(p - roads[0].line_m[i - 1]);
        deepest_m = std::max(deepest_m, std::abs(p.y - mesh::sample(before, p.x / 4 + 128, p.z / 4 + 128)));
    }
    EXPECT_GT(climbing_m, 1.5F * 300);
    EXPECT_LT(deepest_m, 9);
}

TEST(Sites, AreLevelDryAndReached) {
    int sites = 0;
    int reached = 0;
    for (std::uint64_t seed = 0; seed < tests::of(60U); ++seed) {
        const scene::Land land = settled(seed, -1, 1);
        if (!land.site) continue;
        ++sites;
        const glm::vec2 middle = plan(land.site->middle_m);
        for (float turn = 0; turn < 6.28F; turn += 0.3F) {
            for (const float share : {0.2F, 0.5F, 0.8F}) {
                const glm::vec2 at = middle + share * land.site->radius_m * glm::vec2{std::cos(turn), std::sin(turn)};
                EXPECT_EQ(scene::water_depth_m(land, at), 0) << seed;
                EXPECT_GT(scene::ground_height_m(land, at), 0.5F) << seed;
                EXPECT_LT(std::abs(scene::ground_height_m(land, at) - land.site->middle_m.y),
                          0.13F * land.site->radius_m)
                    << seed;
                EXPECT_LT(scene::to_road_m(land, at), 0.0F);
            }
        }
        bool is_reached = false;
        for (const scene::Road& road : land.roads)
            is_reached = is_reached || glm::length(plan(road.line_m.front()) - middle) < land.site->radius_m + 6;
        reached += is_reached;
    }
    EXPECT_GT(sites, tests::of(45));
    EXPECT_GE(reached, sites - 1);
}

// Ground kept for a settlement bears a ring of stones that reach into it, and of lintels that rest on two of them.
TEST(Sites, BearARingOfStones) {
    int sites = 0;
    int lying_in_the_air = 0;
    for (std::uint64_t seed = 0; seed < tests::of(16U); ++seed) {
        const scene::Land land = settled(seed, -1, 1);
        if (!land.site) continue;
        ++sites;
        ASSERT_FALSE(land.landmarks.empty()) << seed;
        const glm::vec2 middle = plan(land.site->middle_m);
        EXPECT_LT(glm::length(plan(land.landmarks.back().at_m) - middle), 1.0F) << seed;
        int uprights = 0;
        for (const auto& piece : mesh::pieces_of(land.stone.mesh)) {
            float low_m = 100;
            float high_m = -100;
            bool is_on_site = true;
            for (std::size_t i = 0; i < 3 * piece.size(); ++i) {
                const glm::vec3& p = land.stone.mesh.positions_m[land.stone.mesh.indices[piece[i / 3] + i % 3]];
                const float over_m = p.y - scene::ground_height_m(land, plan(p));
                low_m = std::min(low_m, over_m);
                high_m = std::max(high_m, over_m);
                is_on_site = is_on_site && glm::length(plan(p) - middle) < 0.9F * land.site->radius_m;
            }
            if (!is_on_site) continue;
            uprights += low_m < 0 && high_m > 1.5F;
            lying_in_the_air += low_m > 7;
        }
        EXPECT_GE(uprights, 5) << seed;
    }
    EXPECT_GE(sites, tests::of(12));
    EXPECT_EQ(lying_in_the_air, 0);
}

// Where the genes ask for such stone, a third of the lands have a slope that bears a cave; of nearly all the flight
// shows one or an arch.
TEST(Landmarks, AreInSightOfTheFlight) {
    int lands = 0;
    int caves = 0;
    int in_sight = 0;
    int large = 0;
    int caves_large = 0;
    for (std::uint64_t seed = 0; seed < tests::of(16U); ++seed) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        scene::SceneParameters p = scene::realise(recipe.values);
        p.land.arch_share = 0.8F;
        scene::Land land = grow_land(p.land, recipe.seeds[genome::Aspect::Land],
                                     {.land_samples = 257, .light_px = 64, .albedo_px = 64});
        const Lookout lookout(land);
        const scene::Track track = fly(fitted_to(lookout, plan_flight(recipe.flight)), lookout, recipe.flight);
        ++lands;
        caves += std::ranges::any_of(land.landmarks, &scene::Landmark::has_front);
        const Outlook seen = outlook(land, scene::camera_at(track, 12));
        in_sight += seen.made > 0.15F;
        constexpr float kLarge_rad = 0.09F;  // an eighth of the picture's height
        large += std::max(seen.marked, seen.cave) > kLarge_rad;
        caves_large += seen.cave > kLarge_rad;
    }
    std::printf("of %d lands %d have a cave, in %d the flight shows one or an arch, in %d large, a cave in %d\n", lands,
                caves, in_sight, large, caves_large);
    if (tests::kIsSanitized) return;  // too few lands for a share of them
    EXPECT_GE(3 * caves, lands);
    EXPECT_GE(4 * in_sight, 3 * lands);
    EXPECT_GE(4 * large, 3 * lands);
    EXPECT_GE(2 * caves_large, caves) << "of those that have one";
}

// A road is no thread at the horizon: the flight stands beside it, and it leads into the picture.
TEST(Roads, LeadIntoThePicture) {
    constexpr float kWide = 0.01F;  // of the picture
    int lands = 0;
    int wide = 0;
    for (std::uint64_t seed = 0; seed < tests::of(24U); ++seed) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        scene::SceneParameters p = scene::realise(recipe.values);
        p.land.road_share = 0.8F;
        p.land.settle_age = p.land.site_share = p.land.arch_share = -1;  // nothing else to look at
        const scene::Land land = grow_land(p.land, recipe.seeds[genome::Aspect::Land],
                                           {.land_samples = 257, .light_px = 64, .albedo_px = 64});
        if (land.roads.empty()) continue;
        const Lookout lookout(land);
        const scene::Track track = fly(fitted_to(lookout, plan_flight(recipe.flight)), lookout, recipe.flight);
        ++lands;
        wide += outlook(land, scene::camera_at(track, 12)).road > kWide;
    }
    std::printf("in %d of %d lands with a road it covers a hundredth of the picture\n", wide, lands);
    if (tests::kIsSanitized) return;  // too few lands for a share of them
    EXPECT_GE(lands, 12);
    EXPECT_GE(4 * wide, 3 * lands);
}

// What a low arch is: rock of which some hangs over one's head. Found by its facets that look down.
TEST(Landmarks, AreFinsThatOneCanStandUnderWhereArchesAreLow) {
    int lands = 0;
    int with_roof = 0;
    for (std::uint64_t seed = 0; seed < tests::of(10U); ++seed) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        scene::SceneParameters p = scene::realise(recipe.values);
        p.land.arch_share = 0.8F;
        p.land.arch_height_m = 12;
        p.land.site_share = -1;
        const scene::Land land = grow_land(p.land, recipe.seeds[genome::Aspect::Land],
                                           {.land_samples = 257, .light_px = 64, .albedo_px = 64});
        const auto fin = std::ranges::find_if_not(land.landmarks, &scene::Landmark::has_front);
        if (fin == land.landmarks.end()) continue;
        ++lands;
        const mesh::Mesh& mesh = land.stone.mesh;
        int overhead = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::vec3& a = mesh.positions_m[mesh.indices[i]];
            const glm::vec3& b = mesh.positions_m[mesh.indices[i + 1]];
            const glm::vec3& c = mesh.positions_m[mesh.indices[i + 2]];
            const glm::vec3 across = glm::cross(b - a, c - a);
            const bool looks_down = across.y < -0.5F * glm::length(across);
            const float over_m = a.y - scene::ground_height_m(land, plan(a));
            overhead += looks_down && over_m > 1.9F && glm::distance(plan(a), plan(fin->at_m)) < fin->size_m;
        }
        with_roof += overhead > 10;
    }
    EXPECT_GE(2 * lands, tests::of(10));
    EXPECT_GE(4 * with_roof, 3 * lands);
}

TEST(Stones, FaceOutwardAndKeepToTheLand) {
    for (std::uint64_t seed = 0; seed < tests::of(12U); ++seed) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        scene::SceneParameters p = scene::realise(recipe.values);
        p.land.arch_share = 1;
        p.land.ledge_share = -1;   // masonry is open where it stands in the ground,
        p.land.climber_share = 0;  // and leaves are open all around
        const scene::Land land = grow_land(p.land, recipe.seeds[genome::Aspect::Land],
                                           {.land_samples = 257, .light_px = 64, .albedo_px = 64});
        const mesh::Mesh& mesh = land.stone.mesh;
        ASSERT_EQ(mesh.positions_m.size(), land.stone.colours.size());
        EXPECT_LT(mesh.triangle_count(), 12000U);
        double volume_m3 = 0;
        const glm::dvec3 middle{mesh.positions_m.empty() ? glm::vec3{0} : mesh.positions_m.front()};
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const glm::dvec3 a = glm::dvec3{mesh.positions_m[mesh.indices[i]]} - middle;
            const glm::dvec3 b = glm::dvec3{mesh.positions_m[mesh.indices[i + 1]]} - middle;
            const glm::dvec3 c = glm::dvec3{mesh.positions_m[mesh.indices[i + 2]]} - middle;
            volume_m3 += glm::dot(a, glm::cross(b, c)) / 6;
            const glm::vec3 normal = mesh.normals[mesh.indices[i]];
            EXPECT_GT(glm::dot(glm::dvec3{normal}, glm::cross(b - a, c - a)), 0);
        }
        EXPECT_TRUE(mesh.indices.empty() || volume_m3 > 0) << seed;
        // Closed: along every edge two facets meet, one each way.
        std::map<std::array<float, 6>, int> edges;
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            const glm::vec3& a = mesh.positions_m[mesh.indices[i]];
            const glm::vec3& b = mesh.positions_m[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
            ++edges[{a.x, a.y, a.z, b.x, b.y, b.z}];
            --edges[{b.x, b.y, b.z, a.x, a.y, a.z}];
        }
        for (const auto& [edge, surplus] : edges) ASSERT_EQ(surplus, 0) << seed << ' ' << edge[0] << ' ' << edge[1];
        for (const glm::vec3& at : mesh.positions_m) EXPECT_LT(std::max(std::abs(at.x), std::abs(at.z)), 512) << seed;
    }
}

}  // namespace
