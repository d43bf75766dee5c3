// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "base/seed.hpp"

// Gradient noise on the integer lattice (Perlin 1985, 2002), with a gradient hashed for each lattice point instead of a
// permutation table, and the sums of octaves that fractal land and clouds are made of (Musgrave in "Texturing and
// Modeling", 1994). Mean 0. One point or many at once: the same bits.
namespace quadrat::synthesis::noise {

// One field of noise. Fields of different keys are unrelated.
struct Key {
    std::uint32_t value = 0;

    explicit Key(base::Seed seed) : value(static_cast<std::uint32_t>(seed.value ^ (seed.value >> 32U))) {}
    explicit constexpr Key(std::uint32_t v) : value(v) {}
};

// In about [-1, 1], deviation about 0.3; 0 at lattice points. |x|, |y| < 2^22.
float gradient(Key key, float x, float y);

enum class Basis {
    Gradient,  // Perlin's
    Simplex,   // Perlin's of 2001: rounder
    Value,     // a number a lattice point: softer, blockier
    Cells,     // Worley's of 1996: 1 on the points, falling with the distance to the nearest
    Cracks,    // and the difference to the second nearest: plates with seams
};

// How octaves become one height (Musgrave).
enum class Mix {
    Sum,     // fBm
    Ridged,  // sharp crests, smooth valleys
    Hybrid,  // rough heights, smooth lows
    Hetero,  // roughness grows with height
};

struct Octaves {
    int count = 6;
    float gain = 0.5F;     // amplitude of an octave to the one before
    float ridged = 0;      // of Mix::Sum: 0 plain fBm, 1 each octave folded to 1 - 2|n|
    float lacunarity = 2;  // frequency of an octave to the one before
    Basis basis = Basis::Gradient;
    Mix mix = Mix::Sum;
};

// Octaves mixed and brought to about [-1, 1], for Mix::Sum by the sum of their amplitudes. Each octave is turned
// against the one before, so that the lattice's directions do not add up.
float fbm(Key key, float x, float y, const Octaves& octaves);
void fbm(Key key, std::span<const float> xs, std::span<const float> ys, std::span<float> out, const Octaves& octaves);

// The same law over octaves that something else has made: their values at one place, about [-1, 1], first to last.
float mixed(std::span<const float> values, const Octaves& octaves);

// Repeats after period > 0 (gradient noise, summed) cells of the first octave; lacunarity is 2 and octaves are not
// turned. Coordinates lie in [0, period).
float fbm_tiled(Key key, float x, float y, int period, const Octaves& octaves);
void fbm_tiled(Key key, std::span<const float> xs, std::span<const float> ys, std::span<float> out, int period,
               const Octaves& octaves);

}  // namespace quadrat::synthesis::noise
