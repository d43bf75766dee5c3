// SPDX-License-Identifier: Apache-2.0
#include "tempo/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrat::tempo {
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

GpuProfile profile_of(const FrameCosts& costs, double pixels) {
    const auto& [much, little, small, smooth] = costs;
    GpuProfile profile;
    profile.much = much;
    profile.little = little;
    profile.pixels = pixels;
    profile.triangles_per_s = rate(much.triangles - little.triangles, much.ms - little.ms);
    profile.pixels_per_s =
        rate(pixels * (little.scale * little.scale - small.scale * small.scale), little.ms - small.ms);
    profile.always_ms = std::max(0.0, little.ms - profile.frame_ms(little.alpha, little.scale));
    profile.samples = smooth.samples;
    if (profile.samples > 1) profile.smooth_ms = std::max(smooth.ms - much.ms, 0.0);
    return profile;
}

std::string to_text(const GpuProfile& profile) {
    const auto per_second = [](double rate, const char* what) {
        return std::isfinite(rate) ? fmt::format("{:.0f} million {} a second", rate / 1e6, what)
                                   : fmt::format("{} for nothing", what);
    };
    std::string text =
        fmt::format("{}, {}, {:.1f} ms whatever is drawn", per_second(profile.triangles_per_s, "triangles"),
                    per_second(profile.pixels_per_s, "pixels"), profile.always_ms);
    if (profile.samples > 1) text += fmt::format(", {:.1f} ms for smooth edges", profile.smooth_ms);
    if (profile.upload_bytes_per_s > 0)
        text += fmt::format(", {:.0f} MB a second to it", profile.upload_bytes_per_s / 1e6);
    return text;
}

GovernorOptions start_for(const GpuProfile& profile, float most, double period_ms) {
    GovernorOptions options;
    options.most = most;
    for (int periods = 1; periods <= GovernorOptions::kMostPeriods; ++periods) {
        options.periods = periods;
        for (float level = most; level >= GovernorOptions::kLeast; level *= 0.97F) {
            options.start = level;
            const double left_ms = kShare * period_ms * periods - profile.frame_ms(alpha_for(level), scale_for(level));
            if (left_ms < 0) continue;
            if (level >= most && periods == 1 && left_ms >= profile.smooth_ms) options.samples = profile.samples;
            return options;
        }
    }
    options.start = std::min(GovernorOptions::kLeast, most);
    return options;
}

}  // namespace quadrat::tempo
