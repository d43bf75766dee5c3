// SPDX-License-Identifier: Apache-2.0
#include "scene/lamps.hpp"

#include <gtest/gtest.h>

namespace quadrat::scene {
namespace {

TEST(Lamps, AreLitAsItDarkens) {
    Settlement settlement;
    settlement.lit_share = 0.6F;
    Sky sky;
    float before = 0;
    for (const float high : {1.0F, 0.3F, 0.2F, 0.1F, 0.0F}) {
        sky.sun_direction.y = high;
        const float lit = lit_windows(settlement, sky);
        EXPECT_GE(lit, before) << high;
        before = lit;
    }
    EXPECT_GT(before, 0.5F) << "at sunset";
    sky.sun_direction.y = 0.9F;  // the moon's
    sky.is_night = true;
    EXPECT_GT(lit_windows(settlement, sky), 0.6F);
    settlement.lit_share = 0;
    EXPECT_GT(lit_windows(settlement, sky), 0.3F);
    settlement.lit_share = 1;
    EXPECT_EQ(lit_windows(settlement, sky), 1);
    sky.is_night = false;
    EXPECT_EQ(lit_windows(settlement, sky), 0) << "by day";
}

TEST(Lamps, OfSoManyWindowsThatShareIsLit) {
    int lit = 0;
    for (int i = 1; i <= 1000; ++i) lit += is_lit(static_cast<float>(i) / 1000, 0.37F, 0.25F);
    EXPECT_NEAR(lit, 250, 2);
    EXPECT_FALSE(is_lit(0, 0.1F, 1)) << "no window";
}

}  // namespace
}  // namespace quadrat::scene
