// SPDX-License-Identifier: Apache-2.0
#include "tempo/full_rate_probe.hpp"

#include <gtest/gtest.h>

namespace quadrat::tempo {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds kFrame = 33ms;

// When the way is open, where every so-manieth frame has no room; nothing within twenty minutes: at no time.
std::optional<std::chrono::nanoseconds> opens_after(bool is_growing, int misses_every) {
    FullRateProbe way_back;
    for (std::chrono::nanoseconds now = 0s; now < 20min; now += kFrame) {
        if (!way_back.watch(now)) return std::nullopt;
        way_back.frame(now, now / kFrame % misses_every == misses_every - 1 ? 1.0F : 0.5F, is_growing);
        if (way_back.is_open(now)) return now;
    }
    return std::nullopt;
}

TEST(FullRateProbe, OpensAfterAMinuteInWhichLandscapesGrewAndAfterTenInWhichNoneDid) {
    constexpr int kNever = 1 << 30;
    EXPECT_NEAR(static_cast<double>(opens_after(true, kNever).value_or(0s) / 1s), 60, 1);
    EXPECT_NEAR(static_cast<double>(opens_after(false, kNever).value_or(0s) / 1s), 600, 1);
}

TEST(FullRateProbe, ForgivesOneFrameInFourHundredAndNoMore) {
    EXPECT_TRUE(opens_after(false, 400).has_value());
    EXPECT_FALSE(opens_after(false, 300).has_value());
}

}  // namespace
}  // namespace quadrat::tempo
