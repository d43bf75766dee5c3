// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/exposure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/sky_parameters.hpp"
#include "synthesis/compose/near_shade.hpp"
#include "synthesis/grow.hpp"

namespace quadrat::synthesis {
namespace {

// A level land of one colour in so much light, under a usual sky, seen from a little above.
struct Plain {
    scene::Land land;
    scene::Sky sky = grow_sky({}, base::Seed{1});
    scene::BakedLight light;
    scene::Track track;

    Plain(std::uint8_t colour, std::uint8_t halved_light) {
        land.height_m = mesh::Field(65, 65);
        for (float& height : land.height_m.samples) height = 5;
        land.cell_m = 16;
        mesh::Image ground(64, 64, 4);
        std::ranges::fill(ground.bytes, colour);
        land.albedo = scene::GroundColours(ground);
        light.ground = mesh::Image(32, 32, 4);
        std::ranges::fill(light.ground.bytes, halved_light);
        track.cameras = {{{0, 9, 0}, {0, 4, -10}, 42}};
    }
    // West of the eye, half of what it sees.
    void darken_half() {
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 16; ++x)
                for (int c = 0; c < 3; ++c) light.ground.pixel(x, y)[c] = 4;
    }
    float exposure() const { return exposure_for(land, sky, light, track); }
};

TEST(Exposure, LeavesWhatIsLitAndNotTooBrightAlone) {
    for (Plain plain : {Plain(170, 128), Plain(190, 100)}) {
        // All of one shade it would be shown brighter, for the range that brings.
        EXPECT_GT(plain.exposure(), 1);
        plain.darken_half();
        EXPECT_EQ(plain.exposure(), 1);
    }
}

// The light end goes up, not past what a picture may be.
TEST(Exposure, ShowsWhatHasLittleRangeBrighter) {
    Plain plain(170, 128);
    EXPECT_LE(std::pow(plain.exposure(), 0.45F), 1.23F);
    EXPECT_GT(std::pow(plain.exposure(), 0.45F), 1.03F);
}

TEST(Exposure, OpensForALandInWhichNothingIsLit) {
    EXPECT_GT(Plain(90, 60).exposure(), 1.5F);
    // And never so far that a night would be a day.
    EXPECT_LE(std::pow(Plain(30, 5).exposure(), 0.45F), 2.11F);
}

TEST(Exposure, OpensLessByNight) {
    Plain dark(140, 70);
    const float by_day = dark.exposure();
    dark.sky.is_night = true;
    EXPECT_LT(dark.exposure(), by_day);
}

TEST(Exposure, StopsDownForSnowInTheSunButNotIntoTheDark) {
    const float snow = Plain(245, 140).exposure();
    EXPECT_LT(snow, 0.95F);
    EXPECT_GE(snow, 0.45F);
    // What is shown follows light to about this power: nearly white becomes a light grey, no darker.
    EXPECT_GT(std::pow(snow, 0.45F), 0.7F);
}

TEST(Exposure, NeverRisesWithTheLight) {
    float before = 2;
    for (const int light : {60, 100, 140, 180, 220, 255}) {
        const float now = Plain(245, static_cast<std::uint8_t>(light)).exposure();
        EXPECT_LE(now, before + 1e-6F) << light;
        before = now;
    }
}

// A plain of one shade under an even sky has the two and what lies between; a dark half widens the range.
TEST(ValueRange, GrowsWithTheShadeOverWhatIsNear) {
    Plain even(150, 110);
    const auto range = [&] { return value_range(even.land, even.sky, even.light, even.track); };
    const float before = range();
    EXPECT_GE(before, 0);
    EXPECT_LE(before, 1);
    std::vector<scene::Plant> none;
    shade_what_is_near(even.light, none, {}, even.track, even.land.side_m(), 0.2F);
    EXPECT_GT(range(), before + 0.05F);
}

TEST(ValueRange, OfNothingIsWhole) { EXPECT_EQ(value_range({}, {}, {}, {}), 1); }

}  // namespace
}  // namespace quadrat::synthesis
