// SPDX-License-Identifier: Apache-2.0
#include "tempo/memory.hpp"

#include <gtest/gtest.h>

#include <string>

namespace quadrat::tempo {
namespace {

TEST(Memory, AGovernorStartsWhereItEndedOnTheSameGpuOnly) {
    GovernorOptions ended;
    ended.start = 0.43F;
    const std::string text = to_text(DetailGovernor(ended), "V3D 4.2");
    EXPECT_NEAR(options_for(1, text, "V3D 4.2").start, 0.43F, 1e-3F);
    EXPECT_EQ(options_for(1, text, "V3D 7.1").start, 1.0F);
}

TEST(Memory, WhatCannotBeReadCountsForNothing) {
    for (const char* broken : {"", "1", "1 ", "1 x V3D 4.2", "9 0.5 V3D 4.2", "1 nan V3D 4.2", "1 -3 V3D 4.2", "1 0.5",
                               "1x 0.5 V3D 4.2", "1x4", "1x40.5 V3D 4.2"})
        EXPECT_EQ(options_for(0.7F, broken, "V3D 4.2").start, 0.7F) << broken;
}

TEST(Memory, KeepsSmoothEdges) {
    GovernorOptions smooth;
    smooth.start = 0.8F;
    smooth.samples = 4;
    const GovernorOptions again = options_for(1, to_text(DetailGovernor(smooth), "V3D 4.2"), "V3D 4.2");
    EXPECT_EQ(again.samples, 4);
    EXPECT_NEAR(again.start, 0.8F, 1e-3F);
}

TEST(Memory, AProfileIsOfOneGpu) {
    const std::string profile = to_text(GpuProfile{}, "V3D 4.2");
    EXPECT_TRUE(is_profile_of(profile, "V3D 4.2"));
    EXPECT_FALSE(is_profile_of(profile, "V3D 4"));
    EXPECT_FALSE(is_profile_of("", "V3D 4.2"));
}

}  // namespace
}  // namespace quadrat::tempo
