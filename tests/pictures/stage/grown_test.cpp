// SPDX-License-Identifier: Apache-2.0
// What has grown, its sky and its light with it, looks as it did.
#include <gtest/gtest.h>

#include <ostream>

#include "pictures/golden.hpp"
#include "pictures/weather.hpp"
#include "stage/easel.hpp"

namespace quadrat::stage {
namespace {

genome::Recipe recipe_of(const char* weather, const char* hour, std::uint64_t seed = 5) {
    genome::Recipe recipe = tests::place(seed);
    tests::set_all(recipe, tests::named(tests::weathers(), weather));
    tests::set_all(recipe, tests::named(tests::hours(), hour));
    for (const genome::Aspect aspect : genome::kAspects) genome::make_consistent(aspect, recipe.values);
    return recipe;
}

struct Looked {
    const char* golden;
    const char* weather;
    const char* hour;
    friend void PrintTo(const Looked& looked, std::ostream* to) { *to << looked.weather << ", " << looked.hour; }
};

class GrownPictures : public testing::TestWithParam<Looked> {};

TEST_P(GrownPictures, LookAsTheyDid) {
    Easel easel(320, 180);
    pictures::Picture picture;
    picture.scenes = {recipe_of(GetParam().weather, GetParam().hour)};
    picture.width = 320;
    picture.height = 180;
    picture.seconds = 12;
    picture.land_samples = 257;
    tests::expect_golden(std::string("grown_") + GetParam().golden, easel.draw(picture));
}

INSTANTIATE_TEST_SUITE_P(ByHourAndWeather, GrownPictures,
                         testing::Values(Looked{"noon", "fair", "noon"}, Looked{"sunset", "fair", "evening"},
                                         Looked{"night", "clear", "night"}, Looked{"storm", "storm", "noon"},
                                         Looked{"snow", "snow", "morning"}, Looked{"fog", "fog", "morning"}),
                         [](const auto& looked) { return std::string(looked.param.golden); });

// Full HD within the triangles that a Raspberry Pi 4 has time for; compared at a third of the size.
TEST(GrownPicture, OfFourViewsWithinARaspberryPisBudgetLooksAsItDid) {
    Easel easel(1920, 1080);
    pictures::Picture picture;
    picture.scenes = {recipe_of("fair", "noon", 1), recipe_of("clear", "evening", 2), recipe_of("fog", "morning", 3),
                      recipe_of("storm", "noon", 4)};
    picture.width = 1920;
    picture.height = 1080;
    picture.seconds = 12;
    const mesh::Image drawn = easel.draw(picture, tempo::Budget{240'000, 0});
    tests::expect_golden("grown_raspberry_pi", pictures::scaled_to(drawn, 640));
}

}  // namespace
}  // namespace quadrat::stage
