// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/mirror.hpp"
#include "scene/sky_parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "synthesis/grow.hpp"

namespace quadrat::synthesis {
namespace {

constexpr float kAway_m = 200;  // of a dark wall beyond the water, straight in the north
constexpr float kTall_m = 60;

// Water about the eye, and from so far north on a plateau with a steep edge.
scene::Scene walled_lake() {
    auto land = std::make_shared<scene::Land>();
    land->cell_m = 4;
    land->height_m = mesh::Field(257, 257, -6);
    for (int row = 0; row < 257; ++row)
        for (int column = 0; column < 257; ++column)
            if (static_cast<float>(row - 128) * land->cell_m <= -kAway_m) land->height_m.at(column, row) = kTall_m;
    mesh::Image ground(64, 64, 4);
    std::ranges::fill(ground.bytes, std::uint8_t{40});
    land->albedo = scene::GroundColours(ground);
    scene::SkyParameters p;
    p.cloud_cover = 0;
    p.cirrus_cover = 0;
    p.haze_distance_m = 4200;
    scene::Scene scene;
    scene.sky = std::make_shared<scene::Sky>(grow_sky(p, base::Seed{1}));
    scene.land = land;
    scene.flora = std::make_shared<scene::Flora>();
    scene.light.ground = mesh::Image(32, 32, 4);
    std::ranges::fill(scene.light.ground.bytes, std::uint8_t{60});
    scene.track.cameras = {{{0, 8, 0}, {0, 6, -20}, 42}};
    return scene;
}

float light_at(const scene::Mirror& mirror, float bearing_rad, float rise) {
    const glm::vec2 at = scene::mirror_at(bearing_rad - mirror.middle_rad, rise);
    const int x = static_cast<int>(at.x * static_cast<float>(mirror.light.width));
    const int y = static_cast<int>(at.y * static_cast<float>(mirror.light.height));
    const float root = static_cast<float>(mirror.light.pixel(x, y)[1]) * (2.0F / 255);
    return root * root;
}

// Begins and ends over the sea in the west; in between it looks over dry ground in the east.
TEST(Mirror, IsLeftOutWhereTheFlightsMiddleLooksOverNoWater) {
    scene::Scene scene = walled_lake();
    auto land = std::make_shared<scene::Land>(*scene.land);
    for (int row = 0; row < 257; ++row)
        for (int column = 0; column < 257; ++column) {
            // In the west as seen from the eye, and none at the rim, which goes on to the horizon.
            const bool is_sea = column > 8 && column < 128 && std::abs(row - 128) < std::min(143 - column, 110);
            land->height_m.at(column, row) = is_sea ? -6.0F : 5.0F;
        }
    scene.land = land;
    const scene::Camera to_sea{{60, 12, 0}, {40, 10, 0}, 42};
    const scene::Camera inland{{60, 12, 0}, {80, 10, 0}, 42};
    scene.track.cameras = {to_sea, inland, inland, inland, to_sea};
    EXPECT_TRUE(hold_up_mirror(scene).light.bytes.empty());
}

// Its edge stands at height over distance, and farther aside lower by the cosine of the bearing.
TEST(Mirror, ShowsAWallAsHighAsItStandsOverTheWater) {
    const scene::Scene scene = walled_lake();
    const scene::Mirror mirror = hold_up_mirror(scene);
    ASSERT_FALSE(mirror.light.bytes.empty());
    EXPECT_EQ(mirror.at_m.y, 0);
    for (const float bearing : {-0.7F, -0.3F, 0.0F, 0.4F, 0.8F}) {
        const float edge = kTall_m / (kAway_m / std::cos(bearing));
        EXPECT_LT(light_at(mirror, bearing, 0.88F * edge), 0.5F * light_at(mirror, bearing, 1.14F * edge)) << bearing;
    }
}

TEST(Mirror, KnowsHowFarAwayTheShoreIs) {
    const scene::Mirror mirror = hold_up_mirror(walled_lake());
    const std::size_t middle = scene::Mirror::kBearings / 2;
    EXPECT_NEAR(mirror.shore_m[middle], kAway_m, 0.1F * kAway_m);
    // None in the south: open water to the land's edge and beyond.
    EXPECT_GT(mirror.shore_m.front(), 2 * kAway_m);
}

TEST(Mirror, ShowsTreesOnTheFarShoreAndNoneOnTheNear) {
    scene::Scene scene = walled_lake();
    auto flora = std::make_shared<scene::Flora>();
    flora->species.resize(1);
    flora->species[0].height_m = 30;
    flora->species[0].crown_radius_m = 10;
    flora->species[0].bark_colour = glm::vec3{0.0F};
    scene.flora = flora;
    const float over_wall = (kTall_m + 15) / (kAway_m + 20);
    const float without = light_at(hold_up_mirror(scene), 0, over_wall);
    scene.plants = {{0, {0, kTall_m, -kAway_m - 20}}};
    EXPECT_LT(light_at(hold_up_mirror(scene), 0, over_wall), 0.5F * without);
    scene.plants = {{0, {0, 0, -1.5F}}};
    EXPECT_NEAR(light_at(hold_up_mirror(scene), 0, over_wall), without, 0.02F);
}

TEST(Mirror, IsEmptyWhereNoWaterIsSeen) {
    scene::Scene scene = walled_lake();
    auto dry = std::make_shared<scene::Land>(*scene.land);
    std::ranges::fill(dry->height_m.samples, 3.0F);
    scene.land = dry;
    EXPECT_TRUE(hold_up_mirror(scene).light.bytes.empty());
}

TEST(Mirror, RowsAndRisesAreEachOthersInverse) {
    for (const float rise : {0.0F, 0.01F, 0.1F, 0.5F, 1.0F})
        EXPECT_NEAR(scene::mirror_rise(scene::mirror_at(0, rise).y), rise, 1e-4F);
    EXPECT_NEAR(scene::mirror_at(0, 0).x, 0.5F, 1e-6F);
}

}  // namespace
}  // namespace quadrat::synthesis
