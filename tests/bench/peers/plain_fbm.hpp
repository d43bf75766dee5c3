// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "base/seed.hpp"

namespace quadrat::peers {

// Fractional Brownian motion as textbooks have it: a table of permuted numbers, gradients on the plane's lattice, a
// quintic between them (Perlin 2002), one sample and one octave after the other.
class PlainFbm {
  public:
    explicit PlainFbm(base::Seed seed) {
        std::iota(numbers_.begin(), numbers_.end(), std::uint8_t{0});
        base::RandomStream chance{seed};
        for (std::size_t i = numbers_.size(); i > 1; --i)
            std::swap(numbers_[i - 1], numbers_[chance.below(static_cast<std::uint32_t>(i))]);
    }

    float at(float x, float y, int octaves) const {
        float sum = 0;
        float amplitude = 1;
        float whole = 0;
        for (int octave = 0; octave < octaves; ++octave) {
            sum += amplitude * noise(x, y);
            whole += amplitude;
            amplitude *= 0.5F;
            x = 2 * x + 19.7F;
            y = 2 * y + 7.3F;
        }
        return sum / whole;
    }

  private:
    static float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

    float slope(int x, int y, float dx, float dy) const {
        const auto row = numbers_[static_cast<std::uint8_t>(y)];
        const unsigned hash = numbers_[static_cast<std::uint8_t>(row + x)] & 7U;
        const float u = hash < 4 ? dx : dy;
        const float v = hash < 4 ? dy : dx;
        return ((hash & 1U) != 0 ? -u : u) + ((hash & 2U) != 0 ? -v : v);
    }

    float noise(float x, float y) const {
        const int column = static_cast<int>(std::floor(x));
        const int row = static_cast<int>(std::floor(y));
        const float dx = x - static_cast<float>(column);
        const float dy = y - static_cast<float>(row);
        const float across = fade(dx);
        const float a = slope(column, row, dx, dy);
        const float b = slope(column + 1, row, dx - 1, dy);
        const float c = slope(column, row + 1, dx, dy - 1);
        const float d = slope(column + 1, row + 1, dx - 1, dy - 1);
        const float near = a + across * (b - a);
        return near + fade(dy) * (c + across * (d - c) - near);
    }

    std::array<std::uint8_t, 256> numbers_{};
};

}  // namespace quadrat::peers
