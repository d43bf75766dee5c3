// SPDX-License-Identifier: Apache-2.0
#include "render/choose/canopy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/seed.hpp"

namespace quadrat::render::choose {
namespace {

Canopy::Box about(glm::vec2 middle, glm::vec2 half) { return {middle - half, middle + half}; }

TEST(Canopy, LetsAllBeSeenWhereNothingStands) {
    const Canopy canopy;
    EXPECT_FLOAT_EQ(canopy.seen(about({0, 0}, {0.5F, 0.5F})), 1);
    EXPECT_FLOAT_EQ(canopy.seen(about({0.3F, -0.9F}, {0, 0})), 1);
    EXPECT_FLOAT_EQ(canopy.seen(about({3, 3}, {0.1F, 0.1F})), 1) << "beside the view";
}

TEST(Canopy, LetsThroughWhatACrownOfItsOpacityLeaves) {
    Canopy canopy;
    canopy.add(about({0, 0}, {0.6F, 0.6F}), 0.8F);
    // An ellipse has 0.785 of its box.
    EXPECT_NEAR(canopy.seen(about({0, 0}, {0.3F, 0.3F})), 1 - 0.8F * 0.785F, 1e-4F);
    EXPECT_FLOAT_EQ(canopy.seen(about({-0.9F, 0}, {0.05F, 0.1F})), 1);
    canopy.add(about({0, 0}, {0.6F, 0.6F}), 0.8F);
    EXPECT_NEAR(canopy.seen(about({0, 0}, {0.3F, 0.3F})), std::pow(1 - 0.8F * 0.785F, 2.0F), 1e-4F);
}

TEST(Canopy, ShowsHalfOfWhatStandsHalfBehindACrown) {
    Canopy canopy;
    canopy.add(about({-0.5F, 0}, {0.5F, 1}), 1);
    EXPECT_NEAR(canopy.seen(about({0, 0}, {0.25F, 0.5F})), 1 - 0.5F * 0.785F, 1e-4F);
}

TEST(Canopy, NeverShowsMoreForOneCrownMore) {
    base::RandomStream random{base::Seed{5}};
    Canopy canopy;
    const Canopy::Box box = about({0.2F, -0.1F}, {0.15F, 0.2F});
    float before = canopy.seen(box);
    for (int i = 0; i < 200; ++i) {
        canopy.add(about({random.between(-1.2F, 1.2F), random.between(-1.2F, 1.2F)},
                         {random.between(0, 0.4F), random.between(0, 0.4F)}),
                   random.unit_f());
        const float now = canopy.seen(box);
        ASSERT_LE(now, before + 1e-6F);
        ASSERT_GE(now, 0);
        before = now;
    }
    EXPECT_LT(before, 0.2F);
}

// What slowly moves slowly changes, also what is smaller than a cell.
TEST(Canopy, ChangesLittleWithASmallStep) {
    base::RandomStream random{base::Seed{6}};
    Canopy canopy;
    for (int i = 0; i < 60; ++i) canopy.add(about({random.between(-1, 1), random.between(-1, 1)}, {0.1F, 0.15F}), 0.8F);
    for (const float half : {0.002F, 0.02F, 0.2F}) {
        float before = canopy.seen(about({-1, 0.05F}, {half, half}));
        for (float x = -1; x < 1; x += 0.001F) {
            const float now = canopy.seen(about({x, 0.05F}, {half, half}));
            ASSERT_NEAR(now, before, 0.04F) << x << " " << half;
            before = now;
        }
    }
}

}  // namespace
}  // namespace quadrat::render::choose
