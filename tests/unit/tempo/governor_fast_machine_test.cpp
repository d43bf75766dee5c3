// SPDX-License-Identifier: Apache-2.0
// The governor on a machine that has room: what comes now and then is no reason to draw less.
#include <gtest/gtest.h>

#include "tempo/governor.hpp"

namespace quadrat::tempo {
namespace {

using namespace std::chrono_literals;
using Instant = DetailGovernor::Instant;

constexpr Instant kPeriod{16'666'667};

TEST(Governor, DrawsAsMuchWhileLandscapesGrowWhereThereIsMuchRoomBesideThem) {
    for (const float used : {0.3F, 1.0F}) {
        DetailGovernor governor({1, 1});
        for (Instant now{0}; now < 20s; now += kPeriod) governor.frame({now, kPeriod, kPeriod, used, now % 5s < 3s});
        governor.frame({20s, kPeriod, kPeriod, used, true});
        if (used < 1)
            EXPECT_GT(governor.level(), 0.95F);
        else
            EXPECT_LT(governor.level(), 0.45F);
    }
}

TEST(Governor, FirstFramesOfOtherLandscapesThatAreLateTakeNoneOfTheirDetail) {
    DetailGovernor governor({1, 1});
    Instant now{0};
    for (int visit = 0; visit < 20; ++visit) {
        governor.other_landscapes(now);
        for (int frame = 0; frame < 300; ++frame) {
            const Instant took = frame == 1 || frame == 3 || frame == 4 ? 2 * kPeriod : kPeriod;
            now += took;
            governor.frame({now, took, kPeriod, took > kPeriod ? 1.0F : 0.6F, false});
        }
    }
    EXPECT_EQ(governor.settled(), 1);
}

// A fast GPU whose driver pauses for four periods when other landscapes come: less detail would not shorten that.
TEST(Governor, AHiccupTakesNothing) {
    DetailGovernor governor({1, 1});
    int frame = 0;
    for (Instant now{0}; now < 10min; ++frame) {
        const bool is_late = frame % 360 == 90;
        const Instant took = is_late ? 4 * kPeriod : kPeriod;
        now += took;
        governor.frame({now, took, kPeriod, is_late ? 1.0F : 0.4F, false});
    }
    EXPECT_EQ(governor.settled(), 1);
}

}  // namespace
}  // namespace quadrat::tempo
