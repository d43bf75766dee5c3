// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "sound/frame.hpp"
#include "sound/noise_bands.hpp"
#include "sound/surroundings.hpp"

namespace quadrat::sound {

// What is heard of a landscape, endless. Each frame is a function of what is there, the seed and the frame's number:
// it may be asked for in any order and in blocks of any length. Quiet enough that all voices together seldom pass 1.
class Soundscape {
  public:
    explicit Soundscape(base::Seed seed);

    // Adds to the block. What is there may change from block to block; from begin to end of one it glides.
    void add(Block block, FrameIndex first, const Surroundings& at_begin, const Surroundings& at_end) const;

  private:
    void add_noise(Block block, FrameIndex first, const Surroundings& at_begin, const Surroundings& at_end) const;

    base::Seed seed_;
    NoiseBands noise_;
};

}  // namespace quadrat::sound
