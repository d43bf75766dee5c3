// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "genome/recipe.hpp"
#include "kiosk/easel.hpp"
#include "support/effort.hpp"
#include "support/exposure.hpp"

namespace quadrat::kiosk {
namespace {

// sky_sheet measure asks a thousand of them.
TEST(Pictures, OfRandomGenomesAreNeitherBurntOutNorBlack) {
    Easel easel(320, 180);
    for (std::uint64_t seed = 1; seed <= tests::of(80U); ++seed) {
        Picture picture;
        picture.scenes = {genome::random_recipe(base::Seed{seed})};
        picture.width = 320;
        picture.height = 180;
        picture.land_samples = 129;
        const bool is_night = picture.scenes[0].values[genome::ParameterId::night_share] > 0;
        const std::string fault = tests::fault_of(tests::exposure_of(easel.draw(picture)), is_night);
        EXPECT_TRUE(fault.empty()) << "seed:" << seed << ": " << fault;
    }
}

}  // namespace
}  // namespace quadrat::kiosk
