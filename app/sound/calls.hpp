// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "sound/frame.hpp"
#include "sound/noise_bands.hpp"
#include "sound/surroundings.hpp"

namespace quadrat::sound {

// What sounds now and then: birds, insects, frogs, thunder, bells. Adds to the block what of it falls there. Each call
// is known by its singer and its number, so that it is the same whichever blocks it is asked for in.
void add_calls(Block block, FrameIndex first, const Surroundings& heard, const NoiseBands& noise, base::Seed seed);

}  // namespace quadrat::sound
