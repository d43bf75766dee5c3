// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/track.hpp"

#include <gtest/gtest.h>

#include "genome/recipe.hpp"
#include "scene/land_parameters.hpp"
#include "support/effort.hpp"
#include "synthesis/compose/view_merit.hpp"
#include "synthesis/grow.hpp"

namespace quadrat::synthesis {
namespace {

scene::Land plain(float height_m) {
    scene::Land land;
    land.height_m = mesh::Field(129, 129, height_m);
    land.cell_m = 8;
    return land;
}

scene::Camera level(float eye_m) { return {{0, eye_m, 0}, {0, eye_m, -100}, 42}; }

TEST(Outlook, OfAPlainIsHalfSkyAndItsHorizonIsFar) {
    const Outlook seen = outlook(plain(2), level(12));
    EXPECT_NEAR(seen.sky, 0.5F, 0.06F);
    EXPECT_GT(seen.near, 0.1F);  // 10 m over it, the lowest rows meet it within 45 m
    EXPECT_EQ(seen.water, 0);
    EXPECT_GT(outlook(plain(2), level(62)).far, 0.05F);  // from higher up more of it is far
}

TEST(Outlook, OverTheSeaIsWater) {
    const Outlook seen = outlook(plain(-5), level(8));
    EXPECT_NEAR(seen.water, 1 - seen.sky, 1e-4F);
    EXPECT_EQ(seen.near, 0);
}

TEST(Outlook, BeforeASlopeIsWalled) {
    scene::Land land = plain(0);
    for (int row = 0; row < 64; ++row)  // it rises to the north, 8 m each 8 m
        for (int column = 0; column < 129; ++column)
            land.height_m.at(column, row) = 8.0F * static_cast<float>(64 - row);
    const Outlook seen = outlook(land, level(3));
    EXPECT_GT(seen.walled, 0.5F);
    EXPECT_LT(view_merit(seen), view_merit(outlook(plain(2), level(12))));
}

// A barn 24 m long and 10 m high, turned by 30 degrees.
scene::Land with_barn(glm::vec3 foot_m) {
    scene::Land land = plain(2);
    land.settlement.buildings.push_back({{}, {12, 5}, 10, {}});
    scene::House barn;
    barn.foot_m = foot_m;
    barn.yaw_rad = 0.5236F;
    land.settlement.houses.push_back(barn);
    return land;
}

TEST(Outlook, BeforeABarnIsRoofed) {
    const Outlook seen = outlook(with_barn({0, 2, -16}), level(7));
    EXPECT_GT(seen.roofed, 0.4F);
    EXPECT_LT(view_merit(seen), view_merit(outlook(plain(2), level(7))));
    EXPECT_EQ(outlook(with_barn({0, 2, 16}), level(7)).roofed, 0);   // behind
    EXPECT_EQ(outlook(with_barn({0, 2, -70}), level(7)).roofed, 0);  // a subject, not a wall
    EXPECT_LT(outlook(with_barn({14, 2, -20}), level(7)).roofed, 0.9F * seen.roofed);
    scene::Land hill = with_barn({0, 2, -28});
    for (int column = 0; column < 129; ++column) hill.height_m.at(column, 62) = 40;  // 16 m before the eye
    EXPECT_EQ(outlook(hill, level(7)).roofed, 0);
}

// A rock 16 m wide and 12 m high, its foot 2 m in the ground.
scene::Land with_rock(glm::vec3 foot_m) {
    scene::Land land = plain(2);
    for (int i = 0; i <= 16; ++i)
        for (int k = 0; k <= 16; ++k)
            for (const float height_m : {-2.0F, 3.0F, 6.0F, 10.0F})
                land.stone.mesh.positions_m.push_back(
                    foot_m + glm::vec3{static_cast<float>(i) - 8, height_m, static_cast<float>(k) - 8});
    return land;
}

TEST(Outlook, BesideARockThatThePictureCutsOffIsStony) {
    constexpr float kLeft_m = -17;
    const Outlook seen = outlook(with_rock({kLeft_m, 2, -30}), level(6));
    EXPECT_GT(seen.stony, 0.08F);
    EXPECT_LT(seen.stony, 0.3F);
    EXPECT_NEAR(outlook(with_rock({-kLeft_m, 2, -30}), level(6)).stony, seen.stony, 0.03F);
    EXPECT_EQ(outlook(with_rock({0, 2, -30}), level(6)).stony, 0);            // whole: a subject
    EXPECT_EQ(outlook(with_rock({kLeft_m, 2, 30}), level(6)).stony, 0);       // behind
    EXPECT_EQ(outlook(with_rock({3 * kLeft_m, 2, -90}), level(6)).stony, 0);  // far away
    EXPECT_EQ(outlook(with_rock({kLeft_m, -9, -30}), level(6)).stony, 0);     // in the ground
    scene::Land hill = with_rock({kLeft_m, 2, -40});
    for (int column = 0; column < 129; ++column) hill.height_m.at(column, 62) = 40;  // 16 m before the eye
    EXPECT_EQ(outlook(hill, level(6)).stony, 0);
    Outlook much = seen;
    much.stony = seen.stony + 0.2F;
    EXPECT_GT(view_merit(seen), view_merit(much) + 0.5F);
}

TEST(ViewMerit, LikesNearAndFarAndWater) {
    const Outlook good{.sky = 0.36F, .water = 0.12F, .near = 0.2F, .far = 0.15F};
    for (Outlook worse : {Outlook{.sky = 0.36F, .water = 0.0F, .near = 0.2F, .far = 0.15F},
                          Outlook{.sky = 0.36F, .water = 0.12F, .near = 0.0F, .far = 0.15F},
                          Outlook{.sky = 0.36F, .water = 0.12F, .near = 0.2F, .far = 0.0F},
                          Outlook{.sky = 0.75F, .water = 0.12F, .near = 0.2F, .far = 0.15F},
                          Outlook{.sky = 0.36F, .water = 0.12F, .near = 0.2F, .far = 0.15F, .walled = 0.4F},
                          Outlook{.sky = 0.36F, .water = 0.12F, .near = 0.2F, .far = 0.15F, .roofed = 0.4F}})
        EXPECT_LT(view_merit(worse), view_merit(good));
}

// Whatever the land, the flight looks at it: neither into a wall nor only at the sky, and mostly with something near.
TEST(Flight, ShowsSkyAndLandOverEveryGenome) {
    const std::uint64_t seeds = tests::of(40U);
    std::uint64_t with_near = 0;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const genome::Recipe recipe = genome::random_recipe(base::Seed{seed});
        const scene::Land land = grow_land(scene::realise_land(recipe.values), recipe.seeds[genome::Aspect::Land],
                                           {.land_samples = 129, .light_px = 64, .albedo_px = 64});
        const scene::Track track = fly(plan_flight(recipe.flight), Lookout(land), recipe.flight);
        const Outlook seen = outlook(land, track.cameras[track.cameras.size() / 2]);
        EXPECT_GT(seen.sky, 0.08F) << seed;
        EXPECT_LT(seen.sky, 0.72F) << seed;
        EXPECT_LT(seen.walled, 0.45F) << seed;
        if (seen.near > 0.05F || seen.water > 0.05F) ++with_near;
    }
    EXPECT_GE(with_near * 10, seeds * 9);
}

}  // namespace
}  // namespace quadrat::synthesis
