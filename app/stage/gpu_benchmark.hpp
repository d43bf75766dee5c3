// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "render/renderer.hpp"
#include "tempo/calibration.hpp"

namespace quadrat::stage {

// What a GPU takes for the same frame drawn in several ways, without waiting for a screen: where its profile comes
// from.
class GpuBenchmark {
  public:
    // most_samples: a pixel, that may be asked for; more than 1: what they take is measured too.
    explicit GpuBenchmark(int most_samples);

    bool is_over() const { return costs_.size() == ways_.size(); }
    // Draws the frame again and again in the next way, for a second and a half at most, and leaves nothing of it but
    // what it drew. The frame has four views.
    void step(render::Renderer& renderer, render::Frame frame);
    // Once it is over. Measures what can be brought to the GPU, too.
    tempo::GpuProfile profile(render::Renderer& renderer, double pixels) const;
    const std::vector<tempo::FrameCost>& costs() const { return costs_; }

  private:
    std::vector<render::Detail> ways_;
    std::vector<tempo::FrameCost> costs_;
};

}  // namespace quadrat::stage
