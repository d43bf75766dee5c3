// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <vector>

#include "base/seed.hpp"
#include "sound/frame.hpp"

namespace quadrat::sound {

// Noise in octaves and a half, as loops of lengths that have no common divisor: heard together they never repeat. Made
// once; 3 MB. Every band has root mean square 1.
class NoiseBands {
  public:
    static constexpr std::size_t kBands = 6;
    static constexpr std::array<float, kBands> kCentres_Hz{70, 200, 560, 1600, 4000, 9000};

    explicit NoiseBands(base::Seed seed);
    // The channels have nothing to do with one another.
    Frame at(std::size_t band, FrameIndex index) const;

  private:
    std::array<std::vector<float>, kBands> loops_;
};

}  // namespace quadrat::sound
