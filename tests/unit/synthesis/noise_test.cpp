// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "synthesis/noise/gradient.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

const noise::Key kKey{base::Seed{42}};

TEST(GradientNoise, VanishesOnTheLattice) {
    for (int y = -5; y < 5; ++y)
        for (int x = -5; x < 5; ++x)
            EXPECT_NEAR(noise::gradient(kKey, static_cast<float>(x), static_cast<float>(y)), 0, 1e-6);
}

TEST(GradientNoise, StaysInItsRangeWithMeanZero) {
    double sum = 0;
    double squares = 0;
    float most = 0;
    constexpr int kSide = 400;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const float n = noise::gradient(kKey, 0.371F * static_cast<float>(x), 0.371F * static_cast<float>(y));
            sum += n;
            squares += static_cast<double>(n) * n;
            most = std::max(most, std::abs(n));
        }
    }
    const double mean = sum / (kSide * kSide);
    EXPECT_NEAR(mean, 0, 0.01);
    EXPECT_NEAR(std::sqrt(squares / (kSide * kSide)), 0.3, 0.06);
    EXPECT_LE(most, 1.6F);
    EXPECT_GT(most, 0.7F);
}

TEST(GradientNoise, HasNoCornersAcrossCells) {
    for (float x = 0.9F; x < 1.1F; x += 0.001F) {
        const float a = noise::gradient(kKey, x, 0.4F);
        const float b = noise::gradient(kKey, x + 0.001F, 0.4F);
        const float c = noise::gradient(kKey, x + 0.002F, 0.4F);
        EXPECT_LT(std::abs(a - 2 * b + c), 1e-4F) << x;
    }
}

TEST(Fbm, GivesTheSameBitsForOnePointAndForMany) {
    std::vector<float> xs;
    std::vector<float> ys;
    for (int i = 0; i < 1003; ++i) {
        xs.push_back(0.37F * static_cast<float>(i) - 150.0F);
        ys.push_back(90.0F - 0.21F * static_cast<float>(i));
    }
    const noise::Octaves octaves{.count = 7, .gain = 0.47F, .ridged = 0.3F};
    std::vector<float> many(xs.size());
    noise::fbm(kKey, xs, ys, many, octaves);
    for (std::size_t i = 0; i < xs.size(); ++i) EXPECT_EQ(many[i], noise::fbm(kKey, xs[i], ys[i], octaves)) << i;
}

TEST(GradientNoise, OfOtherKeysIsUnrelated) {
    const noise::Key other{base::Seed{43}};
    double product = 0;
    for (int i = 0; i < 20000; ++i) {
        const float x = 0.37F * static_cast<float>(i % 200);
        const float y = 0.41F * static_cast<float>(i / 200);
        product += static_cast<double>(noise::gradient(kKey, x, y)) * noise::gradient(other, x, y);
    }
    EXPECT_LT(std::abs(product / 20000), 0.006);
}

// Power of one octave more at half the gain squared: the spectrum of fBm falls as gain says.
TEST(Fbm, RoughensWithItsGain) {
    const auto roughness = [](float gain) {
        double sum = 0;
        for (int i = 0; i < 4000; ++i) {
            const float x = 0.173F * static_cast<float>(i);
            const noise::Octaves octaves{.count = 7, .gain = gain};
            const float d = noise::fbm(kKey, x + 0.01F, 0.3F, octaves) - noise::fbm(kKey, x, 0.3F, octaves);
            sum += static_cast<double>(d) * d;
        }
        return sum;
    };
    EXPECT_LT(1.25 * roughness(0.3F), roughness(0.45F));
    EXPECT_LT(1.25 * roughness(0.45F), roughness(0.6F));
}

TEST(Fbm, StaysWithinOne) {
    for (int i = 0; i < 50000; ++i) {
        const float x = 0.137F * static_cast<float>(i % 300);
        const float y = 0.191F * static_cast<float>(i / 300);
        EXPECT_LE(std::abs(noise::fbm(kKey, x, y, {.count = 6, .gain = 0.5F})), 1.0F);
        EXPECT_LE(std::abs(noise::fbm(kKey, x, y, {.count = 6, .gain = 0.5F, .ridged = 1})), 1.6F);
    }
}

TEST(Fbm, TilesWithoutASeam) {
    const noise::Octaves octaves{.count = 5, .gain = 0.5F};
    for (float y = 0; y < 4; y += 0.13F)
        EXPECT_NEAR(noise::fbm_tiled(kKey, 0, y, 4, octaves), noise::fbm_tiled(kKey, 3.9999998F, y, 4, octaves), 1e-4);
}

}  // namespace
