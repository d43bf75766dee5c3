// SPDX-License-Identifier: Apache-2.0
#include "base/portable_math.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace quadrat::base {
namespace {

TEST(PortableMath, AgreesWithTheLibrary) {
    for (double x = -700; x < 700; x += 0.37) EXPECT_NEAR(portable_exp(x) / std::exp(x), 1, 1e-14) << x;
    for (double x = 1e-300; x < 1e300; x *= 1.7) {
        const double expected = std::log(x);
        EXPECT_NEAR(portable_log(x), expected, 1e-14 * std::max(1.0, std::abs(expected))) << x;
    }
    for (double x = -9; x < 9; x += 0.01) {
        const double expected = 0.5 * std::erfc(-x / std::sqrt(2.0));
        EXPECT_NEAR(normal_cumulative(x), expected, 1e-14) << x;
        if (x < -4) {
            EXPECT_NEAR(normal_cumulative(x) / expected, 1, 1e-12) << x;
        }
    }
}

TEST(PortableMath, HasItsLimits) {
    EXPECT_EQ(portable_exp(-1e9), 0);
    EXPECT_EQ(portable_exp(0), 1);
    EXPECT_TRUE(std::isinf(portable_exp(710)));
    EXPECT_TRUE(std::isinf(portable_log(0)));
    EXPECT_TRUE(std::isnan(portable_log(-1)));
    EXPECT_TRUE(std::isnan(portable_exp(std::numeric_limits<double>::quiet_NaN())));
    EXPECT_EQ(portable_log(1), 0);
    EXPECT_EQ(normal_cumulative(0), 0.5);
    EXPECT_EQ(normal_cumulative(-60), 0);
    EXPECT_EQ(normal_cumulative(60), 1);
}

// Written down once: another processor or compiler that gives other bits breaks kept beliefs.
TEST(PortableMath, GivesTheBitsItGave) {
    std::uint64_t hash = 0;
    for (int i = -40; i <= 40; ++i) {
        const double x = i * 0.173;
        for (const double y : {portable_exp(x), portable_log(std::abs(x) + 0.01), normal_cumulative(x)})
            hash = std::rotl(hash, 7) ^ std::bit_cast<std::uint64_t>(y);
    }
    EXPECT_EQ(hash, 7749749490596778384ULL);
}

}  // namespace
}  // namespace quadrat::base
