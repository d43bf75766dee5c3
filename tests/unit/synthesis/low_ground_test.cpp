// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/low_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/synthesis/scenes.hpp"

namespace quadrat::synthesis {
namespace {

// A plain with one gully and one hill.
scene::Land plain(float above_sea_m) {
    scene::Land land;
    land.cell_m = 4;
    land.height_m = mesh::Field(129, 129);
    for (int row = 0; row < 129; ++row)
        for (int column = 0; column < 129; ++column)
            land.height_m.at(column, row) = above_sea_m + (column == 64 ? -6.0F : column > 80 ? 40.0F : 0.0F);
    return land;
}

scene::Track flight(float above_sea_m) {
    scene::Track track;
    for (int i = 0; i < 40; ++i)
        track.cameras.push_back({{2.0F * static_cast<float>(i), above_sea_m + 4, 120}, {0, above_sea_m, -80}, 42});
    return track;
}

TEST(LowGround, IsThatOfThePlainHoweverHighItLies) {
    const float by_the_sea_m = low_ground_m(plain(0), flight(0));
    EXPECT_NEAR(by_the_sea_m, 0, 1);
    EXPECT_NEAR(low_ground_m(plain(100), flight(100)), by_the_sea_m + 100, 1e-3F);
}

TEST(LowGround, IsNotUnderTheSea) {
    EXPECT_EQ(low_ground_m(plain(-30), flight(0)), 0);
    EXPECT_EQ(low_ground_m(plain(30), scene::Track{}), 0);
}

TEST(LowGround, IsWhatAGrownSceneSaysItIs) {
    const scene::Scene scene = test_scenes::grow(genome::random_recipe(base::Seed{3}));
    EXPECT_EQ(scene.floor_m, low_ground_m(*scene.land, scene.track));
}

}  // namespace
}  // namespace quadrat::synthesis
