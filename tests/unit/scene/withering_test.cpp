// SPDX-License-Identifier: Apache-2.0
#include "scene/withering.hpp"

#include <gtest/gtest.h>

namespace quadrat::scene {
namespace {

TEST(Withering, TurnsGreenToStrawOfItsLightnessAndLeavesRockSandAndSnow) {
    const glm::vec3 grass{0.10F, 0.20F, 0.05F};
    const glm::vec3 straw = grass * withering_of(grass, 1);
    EXPECT_GT(straw.r, straw.g);
    EXPECT_NEAR(luminance(straw), luminance(grass), 0.12F * luminance(grass));
    EXPECT_EQ(withering_of(grass, 0), glm::vec3{1});
    const glm::vec3 half = grass * withering_of(grass, 0.5F);
    EXPECT_NEAR(half.r, 0.5F * (grass.r + straw.r), 1e-5F);
    for (const glm::vec3& other : {glm::vec3{0.2F}, {0.45F, 0.36F, 0.24F}, {0.9F, 0.9F, 0.95F}, {0, 0, 0}})
        EXPECT_EQ(withering_of(other, 1), glm::vec3{1});
}

}  // namespace
}  // namespace quadrat::scene
