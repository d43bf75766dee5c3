// SPDX-License-Identifier: Apache-2.0
#include "kiosk/detail/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrat::kiosk {
namespace {

constexpr double kShare = 0.7;  // of the period
constexpr double kFree = std::numeric_limits<double>::infinity();

double rate(double count, double ms) { return count > 0 && ms > 1e-3 ? 1e3 * count / ms : kFree; }

}  // namespace

double GpuProfile::frame_ms(float alpha, float scale) const {
    const double between = (alpha - little.alpha) / (much.alpha - little.alpha);
    const double triangles = std::max(little.triangles + (much.triangles - little.triangles) * between, 0.0);
    return always_ms + 1e3 * (triangles / triangles_per_s + pixels * scale * scale / pixels_per_s);
}

GpuProfile profile_of(const FrameCost& much, const FrameCost& little, const FrameCost& small, double pixels) {
    GpuProfile profile;
    profile.much = much;
    profile.little = little;
    profile.pixels = pixels;
    profile.triangles_per_s = rate(much.triangles - little.triangles, much.ms - little.ms);
    profile.pixels_per_s =
        rate(pixels * (little.scale * little.scale - small.scale * small.scale), little.ms - small.ms);
    profile.always_ms = std::max(0.0, little.ms - profile.frame_ms(little.alpha, little.scale));
    return profile;
}

GovernorOptions start_for(const GpuProfile& profile, float most, double period_ms) {
    GovernorOptions options;
    options.most = most;
    for (const int periods : {1, 2}) {
        options.periods = periods;
        for (float level = most; level >= GovernorOptions::kLeast; level *= 0.97F) {
            options.start = level;
            if (profile.frame_ms(alpha_for(level), scale_for(level)) <= kShare * period_ms * periods) return options;
        }
    }
    options.start = std::min(GovernorOptions::kLeast, most);
    return options;
}

}  // namespace quadrat::kiosk
