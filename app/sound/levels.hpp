// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>

#include "sound/frame.hpp"

namespace quadrat::sound {

// Keeps sound under a ceiling: looks two milliseconds ahead, which is how late it is, and turns down what would pass.
// What stays under it goes through as it is.
class Limiter {
  public:
    static constexpr std::size_t kAhead = 96;  // frames; the first of the output are silence

    explicit Limiter(float ceiling);
    void limit(Block block);

  private:
    float gain_for(float peak);

    float ceiling_;
    float released_ = 1;  // goes down at once and rises slowly
    std::size_t at_ = 0;  // in the rings
    std::array<Frame, kAhead> waiting_{};
    std::array<float, kAhead> wanted_;
    std::array<float, kAhead> least_;
    double sum_;  // of least_
};

// A gain that takes its time: down in about a tenth of a second, up in about a second.
class Fader {
  public:
    explicit Fader(float begins = 1) : gain_(begins) {}
    float next(float wanted);

  private:
    float gain_;
};

float decibels(float gain);  // 20 log10; -200 for 0

}  // namespace quadrat::sound
