// SPDX-License-Identifier: Apache-2.0
#include "stage/gpu_benchmark.hpp"

#include <chrono>

#include "machine/measurement.hpp"

namespace quadrat::stage {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPatience{1500};  // for each way to draw
constexpr std::size_t kMostFrames = 12;
constexpr std::size_t kFewestFrames = 3;

double ms_since(Clock::time_point began) {
    return std::chrono::duration<double, std::milli>(Clock::now() - began).count();
}

}  // namespace

GpuBenchmark::GpuBenchmark(int most_samples) : ways_{{1, 1}, {0.1F, 1}, {0.1F, 0.5F}} {
    if (most_samples > 1) ways_.push_back({1, 1, most_samples});
}

void GpuBenchmark::step(render::Renderer& renderer, render::Frame frame) {
    frame.detail = ways_[costs_.size()];
    frame.holds_distance = false;  // as landscapes that grow are drawn: whole
    tempo::FrameCost cost{frame.detail.alpha, frame.detail.scale};
    std::vector<double> took;
    const auto began = Clock::now();
    // The first one compiles what it needs.
    for (std::size_t n = 0; n <= kMostFrames && (took.size() < kFewestFrames || Clock::now() - began < kPatience);
         ++n) {
        const auto from = Clock::now();
        const render::Drawn drawn = renderer.draw(frame);
        renderer.finish();
        cost.triangles = static_cast<double>(drawn.triangles);
        cost.samples = drawn.samples;
        if (n > 0) took.push_back(ms_since(from));
    }
    cost.ms = machine::percentile(took, 0.5);
    costs_.push_back(cost);
}

tempo::GpuProfile GpuBenchmark::profile(render::Renderer& renderer, double pixels) const {
    tempo::GpuProfile profile =
        tempo::profile_of({costs_[0], costs_[1], costs_[2], costs_.size() > 3 ? costs_[3] : costs_[0]}, pixels);
    profile.upload_bytes_per_s = renderer.upload_bytes_per_s();
    return profile;
}

}  // namespace quadrat::stage
