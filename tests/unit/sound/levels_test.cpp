// SPDX-License-Identifier: Apache-2.0
#include "sound/levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/seed.hpp"

namespace quadrat::sound {
namespace {

float peak_of(const std::vector<Frame>& frames) {
    float peak = 0;
    for (const Frame& frame : frames) peak = std::max({peak, std::abs(frame.left), std::abs(frame.right)});
    return peak;
}

TEST(Limiter, LetsNothingPassItsCeilingWhateverComes) {
    base::RandomStream random(base::Seed{3});
    for (const float ceiling : {1.0F, 0.3F}) {
        Limiter limiter(ceiling);
        std::vector<Frame> frames(48'000);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const float loud = i % 7'000 < 200 ? 9.0F : 0.5F;
            frames[i] = {loud * random.between(-1, 1), i % 5'000 == 77 ? 50.0F : 0.1F};
        }
        frames[20'000].left = std::numeric_limits<float>::quiet_NaN();
        frames[20'001].right = std::numeric_limits<float>::infinity();
        limiter.limit(frames);
        EXPECT_LE(peak_of(frames), ceiling);
        EXPECT_GT(peak_of(frames), 0.5F * ceiling);
    }
}

TEST(Limiter, LeavesWhatIsQuietAsItIsAndTwoMillisecondsLate) {
    Limiter limiter(0.8F);
    std::vector<Frame> frames(4'800);
    for (std::size_t i = 0; i < frames.size(); ++i) frames[i].left = 0.7F * std::sin(0.05F * static_cast<float>(i));
    const std::vector<Frame> before = frames;
    limiter.limit(frames);
    for (std::size_t i = 0; i < Limiter::kAhead - 1; ++i) EXPECT_EQ(frames[i], Frame{});
    for (std::size_t i = Limiter::kAhead; i < frames.size(); ++i)
        ASSERT_NEAR(frames[i].left, before[i - Limiter::kAhead + 1].left, 1e-5F) << i;
}

// A gain that jumped would be heard as a click: of an even tone each sample is near the one before it.
TEST(Limiter, TurnsDownWithoutAStep) {
    Limiter limiter(1);
    std::vector<Frame> frames(9'600);
    for (std::size_t i = 0; i < frames.size(); ++i)
        frames[i].left = (i < 4'800 ? 0.9F : 3.0F) * std::sin(6.2831853F * static_cast<float>(i) / 480);
    limiter.limit(frames);
    for (std::size_t i = 1; i < frames.size(); ++i)
        ASSERT_LT(std::abs(frames[i].left - frames[i - 1].left), 0.045F) << i;
}

TEST(Fader, GoesDownFasterThanItComesBack) {
    Fader fader;
    const auto frames_until = [&](float wanted, float reached) {
        int frames = 0;
        for (float gain = fader.next(wanted); std::abs(gain - wanted) > std::abs(reached); ++frames)
            gain = fader.next(wanted);
        return frames;
    };
    const int down = frames_until(0.2F, 0.05F), up = frames_until(1, 0.05F);
    EXPECT_LT(down, kRate / 5);
    EXPECT_GT(up, 5 * down);
    EXPECT_LT(up, 2 * kRate);
}

TEST(Decibels, AreTwentyTimesTheLogarithm) {
    EXPECT_FLOAT_EQ(decibels(1), 0);
    EXPECT_NEAR(decibels(0.5F), -6.02F, 0.01F);
    EXPECT_EQ(decibels(0), -200);
}

}  // namespace
}  // namespace quadrat::sound
