// SPDX-License-Identifier: Apache-2.0
#include "tempo/calibration.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace quadrat::tempo {
namespace {

constexpr double kPixels = 2e6;

// A GPU whose rates are known.
struct Gpu {
    double always_ms = 2;
    double triangles_per_s = 30e6;
    double pixels_per_s = 400e6;
    double smooth_ms = 3;
    int most_samples = 4;
    FrameCost draw(float alpha, float scale, int samples = 1) const {
        const double triangles = 40'000 + 180'000.0 * alpha;
        const double ms = always_ms + 1e3 * (triangles / triangles_per_s + kPixels * scale * scale / pixels_per_s);
        return {alpha, scale, samples, ms + (samples > 1 ? smooth_ms : 0), triangles};
    }
    GpuProfile profile() const {
        return profile_of({draw(1, 1), draw(0.1F, 1), draw(0.1F, 0.5F), draw(1, 1, most_samples)}, kPixels);
    }
};

TEST(Calibration, FindsTheRatesBehindThreeFrames) {
    const Gpu gpu;
    const GpuProfile profile = gpu.profile();
    EXPECT_NEAR(profile.triangles_per_s, gpu.triangles_per_s, 1e-3 * gpu.triangles_per_s);
    EXPECT_NEAR(profile.pixels_per_s, gpu.pixels_per_s, 1e-3 * gpu.pixels_per_s);
    EXPECT_NEAR(profile.always_ms, gpu.always_ms, 1e-2);
    for (const float alpha : {1.0F, 0.4F, 0.05F})
        for (const float scale : {1.0F, 0.6F})
            EXPECT_NEAR(profile.frame_ms(alpha, scale), gpu.draw(alpha, scale).ms, 1e-2);
}

TEST(Calibration, StartsWhereFramesAreInTime) {
    constexpr double kPeriod_ms = 16.667;
    for (const double slower : {0.5, 1.0, 1.6, 2.5, 4.0}) {
        const Gpu gpu{2 * slower, 30e6 / slower, 400e6 / slower};
        const GovernorOptions start = start_for(gpu.profile(), 1, kPeriod_ms);
        const double ms = gpu.draw(alpha_for(start.start), scale_for(start.start)).ms;
        EXPECT_LE(ms, 0.7 * kPeriod_ms * start.periods + 0.01) << slower;
        const double least_ms = start.start < 0.99F ? 0.6 * kPeriod_ms * start.periods : 0;
        EXPECT_GE(ms, least_ms) << slower << ": no less than needed";
    }
    EXPECT_EQ(start_for(Gpu{1, 300e6, 4e9}.profile(), 0.8F, kPeriod_ms).start, 0.8F)
        << "no more than the site asks for";
    const GovernorOptions hopeless = start_for(Gpu{200, 1e6, 1e7}.profile(), 1, kPeriod_ms);
    EXPECT_EQ(hopeless.start, GovernorOptions::kLeast);
    EXPECT_EQ(hopeless.periods, GovernorOptions::kMostPeriods);
}

TEST(Calibration, TakesWhatIsLostInNoiseToBeFree) {
    const FrameCost fast{1, 1, 1, 3.0, 220'000};
    const FrameCost little{0.1F, 1, 1, 3.1, 58'000};
    const FrameCost small{0.1F, 0.5F, 1, 3.2, 58'000};
    const FrameCost smooth{1, 1, 4, 2.9, 220'000};
    const GpuProfile profile = profile_of({fast, little, small, smooth}, kPixels);
    EXPECT_NEAR(profile.frame_ms(1, 1), 3.1, 1e-6);
    EXPECT_EQ(profile.smooth_ms, 0);
    EXPECT_EQ(start_for(profile, 1, 16.667).start, 1);
    EXPECT_EQ(start_for(profile, 1, 16.667).samples, 4);
}

TEST(Calibration, StartsWithSmoothEdgesWhereTheyAreInTimeBesideAllThatIsAskedFor) {
    constexpr double kPeriod_ms = 16.667;
    const auto samples_on = [](const Gpu& gpu) { return start_for(gpu.profile(), 1, kPeriod_ms).samples; };
    EXPECT_EQ(samples_on({1, 300e6, 4e9, 3}), 4);
    EXPECT_EQ(samples_on({1, 300e6, 4e9, 12}), 1) << "they take too long";
    EXPECT_EQ(samples_on({1, 300e6, 4e9, 3, 1}), 1) << "it has none";
    EXPECT_EQ(samples_on({2, 15e6, 400e6, 0.1}), 1) << "rather all there is, without";
}

TEST(Calibration, IsToldInALineWhateverWasMeasured) {
    GpuProfile profile = Gpu{}.profile();
    EXPECT_EQ(to_text(profile),
              "30 million triangles a second, 400 million pixels a second, 2.0 ms whatever is drawn, 3.0 ms for smooth "
              "edges");
    profile.samples = 1;
    profile.upload_bytes_per_s = 2.5e9;
    profile.triangles_per_s = std::numeric_limits<double>::infinity();
    EXPECT_EQ(to_text(profile),
              "triangles for nothing, 400 million pixels a second, 2.0 ms whatever is drawn, 2500 MB a second to it");
}

}  // namespace
}  // namespace quadrat::tempo
