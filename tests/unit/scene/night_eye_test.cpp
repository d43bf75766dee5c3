// SPDX-License-Identifier: Apache-2.0
#include "scene/night_eye.hpp"

#include <gtest/gtest.h>

#include "scene/colour.hpp"

namespace quadrat::scene {
namespace {

TEST(NightEye, SeesAllColourByDayAndLessTheDarkerItIs) {
    EXPECT_EQ(colour_seen(0), 1);
    EXPECT_GT(colour_seen(0.5F), colour_seen(1));
    EXPECT_GT(colour_seen(1), 0);
    const glm::vec3 leaf{0.2F, 0.4F, 0.05F};
    EXPECT_EQ(seen_by_night(leaf, 1), leaf);
}

TEST(NightEye, LeavesGreyAloneAndMakesRedDarkerThanGreen) {
    const glm::vec3 grey{0.3F};
    EXPECT_NEAR(luminance(seen_by_night(grey, 0)), 0.3F, 1e-6F);
    // Of one lightness by day (Purkinje's shift).
    const glm::vec3 red = glm::vec3{1, 0.1F, 0.1F} * (0.2F / luminance({1, 0.1F, 0.1F}));
    const glm::vec3 blue = glm::vec3{0.1F, 0.3F, 1} * (0.2F / luminance({0.1F, 0.3F, 1}));
    EXPECT_LT(luminance(seen_by_night(red, 0.4F)), 0.6F * luminance(seen_by_night(blue, 0.4F)));
}

}  // namespace
}  // namespace quadrat::scene
