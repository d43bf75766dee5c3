// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/sward.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <map>
#include <utility>
#include <vector>

#include "genome/parameter_table.hpp"
#include "scene/colour.hpp"
#include "scene/parameters.hpp"
#include "synthesis/compose/near_shade.hpp"
#include "synthesis/compose/view_merit.hpp"
#include "synthesis/grow.hpp"
#include "unit/synthesis/plain_colour.hpp"

namespace quadrat::synthesis {
namespace {

// A land 512 m wide: level ground 4 m over the sea in the east, 4 m under it in the west.
scene::Land shore() {
    scene::Land land;
    land.cell_m = 2;
    land.height_m = mesh::Field(257, 257);
    for (int row = 0; row < 257; ++row)
        for (int column = 0; column < 257; ++column) land.height_m.at(column, row) = column < 128 ? -4 : 4;
    land.albedo = tests::plain_colour({90, 120, 60});
    return land;
}

FlightPlan northward() { return {{{{0, 60}, {0, -1}}, {{4, 40}, {0, -1}}}}; }

scene::Sward laid(const scene::Land& land, const scene::Cover& cover = {}) {
    scene::Flora flora;
    flora.cover = cover;
    return lay_sward(land, flora, northward(), base::Seed{3});
}

TEST(Sward, CoversDryGroundBeforeTheEyeAndNothingElse) {
    const scene::Land land = shore();
    const scene::Sward sward = laid(land);
    ASSERT_GT(sward.tufts.size(), 1000U);
    for (const scene::Tuft& tuft : sward.tufts) {
        EXPECT_GT(tuft.root_m.x, -2);
        EXPECT_NEAR(tuft.root_m.y, scene::ground_height_m(land, {tuft.root_m.x, tuft.root_m.z}), 0.05F);
        EXPECT_LT(tuft.root_m.z, 64);
        ASSERT_TRUE(tuft.height_m > 0 && tuft.height_m < 2 && tuft.radius_m > 0 && tuft.radius_m <= 2);
    }
}

// About as many on a piece of the picture wherever it shows: to an area of land fewer the farther, and wider for it.
TEST(Sward, HasFewerAndWiderTuftsTheFarther) {
    const scene::Sward sward = laid(shore());
    struct Ring {
        float nearest_m, farthest_m, tufts = 0, radius_m = 0;
    };
    std::vector<Ring> rings{{4, 24}, {40, 60}, {90, 120}};
    for (const scene::Tuft& tuft : sward.tufts) {
        const float away_m = glm::distance(glm::vec2{tuft.root_m.x, tuft.root_m.z}, glm::vec2{4, 40});
        const float aside_m = std::abs(tuft.root_m.x - 4);
        for (Ring& ring : rings) {
            if (away_m < ring.nearest_m || away_m >= ring.farthest_m || 2 * aside_m > away_m) continue;
            ring.tufts += 1 / (ring.farthest_m * ring.farthest_m - ring.nearest_m * ring.nearest_m);
            ring.radius_m = std::max(ring.radius_m, tuft.radius_m);
        }
    }
    EXPECT_GT(rings[2].tufts, 0) << "it goes on to there";
    EXPECT_LT(rings[1].tufts, 0.65F * rings[0].tufts);
    EXPECT_LT(rings[2].tufts, 0.35F * rings[1].tufts);
    EXPECT_GT(rings[2].tufts, 0.03F * rings[0].tufts);
    EXPECT_GT(rings[2].radius_m, 1.8F * rings[0].radius_m);
}

TEST(Sward, IsThinnerWhereTheFloraIsBarer) {
    scene::Cover bare;
    bare.density = 0;
    EXPECT_LT(laid(shore(), bare).tufts.size(), laid(shore()).tufts.size() / 2);
}

TEST(Sward, LeavesStonesWhereTheGroundBearsNothing) {
    scene::Land stony = shore();
    stony.kinds = mesh::Image(257, 257, 2);
    for (std::size_t i = 1; i < stony.kinds.bytes.size(); i += 2) stony.kinds.bytes[i] = 255;
    const scene::Sward sward = laid(stony);
    ASSERT_GT(sward.tufts.size(), 100U);
    EXPECT_TRUE(
        std::ranges::all_of(sward.tufts, [](const scene::Tuft& tuft) { return tuft.kind == scene::CoverKind::Stone; }));
}

// Of a land of dunes, as its ground is painted.
TEST(Sward, LeavesSandBare) {
    scene::SceneParameters p = scene::realise(genome::ParameterValues{});
    p.land.ground_lushness = -1;
    const auto sown = [&](float dunes) {
        p.land.dune_share = dunes;
        const scene::Land land = grow_land(p.land, base::Seed{5}, {.land_samples = 129});
        return laid(land).tufts.size();
    };
    const std::size_t grass = sown(-1);
    ASSERT_GT(grass, 1000U);
    EXPECT_LT(sown(1), grass / 3);
}

TEST(Sward, ReachesDownToTheWaterWhereTheGroundIsGreen) {
    scene::Land marsh = shore();
    for (float& height_m : marsh.height_m.samples) height_m = height_m > 0 ? 0.3F : height_m;
    EXPECT_GT(laid(marsh).tufts.size(), laid(shore()).tufts.size() / 2);
}

TEST(Sward, IsMownOnGreenGroundThatPeopleUseAndGrowsOnNoneOfTheirEarth) {
    scene::Land used = shore();
    const scene::Sward wild = laid(used);
    used.kept_clear = scene::kept_clear_of(mesh::Field(257, 257));
    const scene::Sward lawn = laid(used);
    const auto tallest_m = [](const scene::Sward& sward) {
        float most = 0;
        for (const scene::Tuft& tuft : sward.tufts) most = std::max(most, tuft.height_m);
        return most;
    };
    ASSERT_GT(lawn.tufts.size(), wild.tufts.size() / 2);
    EXPECT_LT(tallest_m(lawn), 0.6F * tallest_m(wild));
    EXPECT_TRUE(
        std::ranges::all_of(lawn.tufts, [](const scene::Tuft& tuft) { return tuft.kind == scene::CoverKind::Grass; }));
    used.albedo = tests::plain_colour(tests::kEarth);
    EXPECT_TRUE(laid(used).tufts.empty());
}

TEST(Sward, HasNoPatchWithoutAnyWhereTheFloraIsClosed) {
    // By squares of 4 m before the eye, on dry ground.
    scene::Cover closed;
    closed.density = 1;
    closed.patch_m = 6;
    std::map<std::pair<int, int>, int> tufts;
    for (const scene::Tuft& tuft : laid(shore(), closed).tufts)
        ++tufts[{static_cast<int>(tuft.root_m.x / 4), static_cast<int>(tuft.root_m.z / 4)}];
    for (int x = 1; x < 3; ++x)
        for (int z = 2; z < 11; ++z) EXPECT_GE((tufts[{x, z}]), 15) << x << ", " << z;
}

TEST(Sward, KeepsTheTuftsOfACellTogetherKindByKind) {
    const scene::Sward sward = laid(shore());
    std::size_t next = 0;
    for (const scene::Sward::Cell& cell : sward.cells) {
        EXPECT_EQ(cell.first, next);
        for (std::size_t kind = 0; kind < scene::kCoverKinds; ++kind)
            for (std::uint32_t i = 0; i < cell.counts[kind]; ++i, ++next) {
                const scene::Tuft& tuft = sward.tufts[next];
                ASSERT_EQ(static_cast<std::size_t>(tuft.kind), kind);
                ASSERT_TRUE(glm::all(glm::greaterThanEqual(tuft.root_m, cell.low_m)) &&
                            glm::all(glm::lessThanEqual(tuft.root_m, cell.high_m)));
            }
    }
    EXPECT_EQ(next, sward.tufts.size());
}

TEST(Sward, SendsInTheMeanNearlyTheLightOfTheGroundUnderIt) {
    scene::Cover cover;
    cover.grass = scene::linear_from_srgb_hex(0x5A783C);  // the ground's own
    const scene::Land land = shore();
    scene::Sward sward = laid(land, cover);
    scene::BakedLight light{mesh::Image(32, 32, 4)};
    std::ranges::fill(light.ground.bytes, std::uint8_t{128});
    light_sward(sward, land, {}, light, 1);
    glm::vec3 sum{0};
    for (const scene::Tuft& tuft : sward.tufts) sum += tuft.sent;
    const glm::vec3 ground = scene::linear_from_srgb_hex(0x5A783C) * (2 * 128 / 255.0F);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(sum[c] / static_cast<float>(sward.tufts.size()), ground[c], 0.2F * ground[c]);
}

TEST(NearShade, TakesLightNearTheWayAndNoneFarFromIt) {
    scene::BakedLight light{mesh::Image(128, 128, 4)};
    std::ranges::fill(light.ground.bytes, std::uint8_t{200});
    scene::Flora flora;
    flora.species.resize(2);
    flora.species[0].storey = scene::Storey::Herb;
    std::vector<scene::Plant> plants(3);
    plants[1].root_m = {200, 0, 0};
    plants[2].species = 1;
    scene::Track track;
    track.cameras = {scene::Camera{}};
    shade_what_is_near(light, plants, flora, track, 512, kLeftByDay);
    EXPECT_LT(light.ground.pixel(64, 64)[1], 120);
    EXPECT_EQ(light.ground.pixel(64, 64)[3], 200);  // the water's depth
    EXPECT_EQ(light.ground.pixel(2, 64)[1], 200);
    EXPECT_LT(plants[0].sun, 0.6F);
    EXPECT_EQ(plants[1].sun, 1);
    EXPECT_GT(plants[2].sun, 0.75F) << "a tree stands out of it";
    EXPECT_LT(plants[2].sun, 0.95F);
}

TEST(Flight, FittedToALandKeepsItsWayAndMovesALittle) {
    const scene::Land land = shore();
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const FlightPlan plan = plan_flight(base::Seed{seed});
        const FlightPlan fitted = fitted_to(Lookout(land), plan);
        ASSERT_EQ(fitted.stations.size(), plan.stations.size());
        const glm::vec2 shift = fitted.stations.front().at_m - plan.stations.front().at_m;
        EXPECT_LT(glm::length(shift), 110);
        for (std::size_t i = 0; i < plan.stations.size(); ++i) {
            EXPECT_EQ(fitted.stations[i].ahead, plan.stations[i].ahead);
            EXPECT_LT(glm::distance(fitted.stations[i].at_m - plan.stations[i].at_m, shift), 1e-3F);
        }
    }
}

TEST(Flight, LeavesOpenWaterForTheShore) {
    scene::Land sea = shore();
    // Ground in a strip a little east of the way.
    for (int row = 0; row < 257; ++row)
        for (int column = 0; column < 257; ++column)
            sea.height_m.at(column, row) = column > 128 + 25 && column < 128 + 70 ? 4 : -4;
    const FlightPlan fitted = fitted_to(Lookout(sea), northward());
    EXPECT_GT(fitted.stations.front().at_m.x, 40);
}

}  // namespace
}  // namespace quadrat::synthesis
