// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "base/seed.hpp"

// Gradient noise on the integer lattice (Perlin 1985, 2002), with a gradient hashed for each lattice point instead of a
// permutation table, and the sums of octaves that fractal land and clouds are made of (Musgrave in "Texturing and
// Modeling", 1994). Mean 0.
namespace quadrat::synthesis::noise {

// One field of noise. Fields of different keys are unrelated.
struct Key {
    std::uint32_t value = 0;

    explicit Key(base::Seed seed) : value(static_cast<std::uint32_t>(seed.value ^ (seed.value >> 32U))) {}
    explicit constexpr Key(std::uint32_t v) : value(v) {}
    constexpr Key octave(int index) const { return Key{value + 0x9E3779B9U * static_cast<std::uint32_t>(index + 1)}; }
};

// In about [-1, 1], deviation about 0.3; 0 at lattice points. |x|, |y| < 2^22.
float gradient(Key key, float x, float y);

// Repeats after period lattice cells in both directions; period > 0.
float gradient_tiled(Key key, float x, float y, int period);

struct Octaves {
    int count = 6;
    float gain = 0.5F;     // amplitude of an octave to the one before
    float ridged = 0;      // 0 plain fBm, 1 ridges: 1 - 2|n|
    float lacunarity = 2;  // frequency of an octave to the one before
};

// Sum of octaves, divided by the sum of their amplitudes: in [-1, 1]. Each octave is turned against the one before, so
// that the lattice's directions do not add up.
float fbm(Key key, float x, float y, const Octaves& octaves);

// Repeats after period cells of the first octave. Not turned.
float fbm_tiled(Key key, float x, float y, int period, const Octaves& octaves);

}  // namespace quadrat::synthesis::noise
