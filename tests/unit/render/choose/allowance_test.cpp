// SPDX-License-Identifier: Apache-2.0
#include "render/choose/allowance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrat::render::choose {
namespace {

// An error is what falls below alpha 1: all else may only rise.
bool is_error(const AllowanceRow& row) { return row.power_below < 0; }

TEST(Allowance, NoEntryAsksForLessWithMoreAlpha) {
    for (const AllowanceRow& row : allowance_table()) {
        float before = allowance_of({0.005F}, 4).*row.entry;
        for (float alpha = 0.005F; alpha < 120; alpha *= 1.02F) {
            const float now = allowance_of({alpha}, 4).*row.entry;
            if (is_error(row)) {
                ASSERT_LE(now, before) << row.name << " at " << alpha;
            } else {
                ASSERT_GE(now, before) << row.name << " at " << alpha;
            }
            before = now;
        }
        EXPECT_GT(before, 0) << row.name;
    }
}

TEST(Allowance, HasNoLeapWhereItsPowersMeet) {
    for (const AllowanceRow& row : allowance_table()) {
        const float below = allowance_of({0.9999F}, 1).*row.entry;
        const float above = allowance_of({1.0001F}, 1).*row.entry;
        EXPECT_NEAR(below / above, 1, 1e-3) << row.name;
    }
}

TEST(Allowance, IsWhatItsRowSaysAtTheStandard) {
    for (const AllowanceRow& row : allowance_table())
        EXPECT_EQ(allowance_of({}, 1).*row.entry, std::min(row.standard, row.most)) << row.name;
}

TEST(Allowance, IsSharedOutAmongViewsWhereItIsTheFrames) {
    const Allowance one = allowance_of({0.3F}, 1);
    const Allowance four = allowance_of({0.3F}, 4);
    EXPECT_FLOAT_EQ(four.land_triangles, one.land_triangles / 4);
    EXPECT_FLOAT_EQ(four.surround_triangles, one.surround_triangles / 4);
    EXPECT_EQ(four.triangles, one.triangles) << "the frame's already";
    EXPECT_EQ(four.land_error_px, one.land_error_px);
    EXPECT_EQ(allowance_of({0.3F}, 0), one);
}

TEST(Allowance, OfHardlyAnythingIsThatOfAHundredth) { EXPECT_EQ(allowance_of({1e-6F}, 4), allowance_of({0.01F}, 4)); }

}  // namespace
}  // namespace quadrat::render::choose
