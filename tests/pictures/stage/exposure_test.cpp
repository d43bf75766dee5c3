// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "genome/recipe.hpp"
#include "stage/easel.hpp"
#include "support/effort.hpp"
#include "support/exposure.hpp"
#include "support/finite.hpp"

namespace quadrat::stage {
namespace {

// sky_sheet measure asks a thousand of them.
TEST(Pictures, OfRandomGenomesAreNeitherBurntOutNorBlack) {
    Easel easel(320, 180);
    for (std::uint64_t seed = 1; seed <= tests::sample_of(80U); ++seed) {
        pictures::Picture picture;
        picture.scenes = {genome::random_recipe(base::Seed{seed})};
        picture.width = 320;
        picture.height = 180;
        picture.land_samples = 129;
        const bool is_night = picture.scenes[0].values[*genome::parameter_named("night.share")] > 0;
        const auto scene = nursery::grow(picture.scenes[0], pictures::fineness_of(picture.land_samples));
        EXPECT_EQ(tests::not_finite(*scene->sky, scene->exposure), "") << "seed:" << seed;
        EXPECT_EQ(tests::fault_of(tests::exposure_of(easel.draw(picture, nursery::Scenes{scene})), is_night), "")
            << "seed:" << seed;
    }
}

TEST(Pictures, OfLightThatIsNoNumberAreFound) {
    const float none = std::nanf("");
    const auto fault_where = [](const auto& spoil) {
        scene::Sky sky;
        float exposure = 1;
        spoil(sky, exposure);
        return tests::not_finite(sky, exposure);
    };
    EXPECT_EQ(fault_where([](auto&, auto&) {}), "");
    EXPECT_NE(fault_where([&](auto& sky, auto&) { sky.dome.at(40, 20).y = none; }), "");
    EXPECT_NE(fault_where([&](auto& sky, auto&) { sky.ambient.add({0, 1, 0}, {1, none, 1}, 1); }), "");
    EXPECT_NE(fault_where([&](auto& sky, auto&) { sky.haze_sunward.z = none; }), "");
    EXPECT_NE(fault_where([&](auto& sky, auto&) { sky.clouds[1].shaded.x = none; }), "");
    EXPECT_NE(fault_where([&](auto&, auto& exposure) { exposure = none; }), "");
}

}  // namespace
}  // namespace quadrat::stage
