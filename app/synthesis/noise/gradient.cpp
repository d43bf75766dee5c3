// SPDX-License-Identifier: Apache-2.0
#include "synthesis/noise/gradient.hpp"

#include <cmath>

namespace quadrat::synthesis::noise {
namespace {

std::uint32_t lattice_hash(Key key, std::int32_t x, std::int32_t y) {
    std::uint32_t h =
        key.value ^ (static_cast<std::uint32_t>(x) * 0x8DA6B343U) ^ (static_cast<std::uint32_t>(y) * 0xD8163841U);
    h ^= h >> 15U;
    h *= 0x2C1B3C6DU;
    h ^= h >> 12U;
    h *= 0x297A2D39U;
    h ^= h >> 15U;
    return h;
}

// The gradient's components are uniform over [-1, 1): its covariance is round, and two shifts make it.
float corner(std::uint32_t hash, float dx, float dy) {
    const float gx = static_cast<float>(static_cast<std::int32_t>(hash & 0xFFFFU) - 32768) * (1.0F / 32768.0F);
    const float gy = static_cast<float>(static_cast<std::int32_t>(hash >> 16U) - 32768) * (1.0F / 32768.0F);
    return gx * dx + gy * dy;
}

float fade(float t) { return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F); }

constexpr float kScale = 1.5F;  // brings the deviation to about 0.3

float blend(float n00, float n10, float n01, float n11, float dx, float dy) {
    const float u = fade(dx);
    const float above = n00 + u * (n10 - n00);
    const float below = n01 + u * (n11 - n01);
    return kScale * (above + fade(dy) * (below - above));
}

int wrapped(int i, int period) {
    const int r = i % period;
    return r < 0 ? r + period : r;
}

float shaped(float n, float ridged) { return n + ridged * (1.0F - 2.0F * std::abs(n) - n); }

// A turn by 36.87 degrees, exact in its digits (3-4-5), between octaves.
constexpr float kCos = 0.8F;
constexpr float kSin = 0.6F;

}  // namespace

float gradient(Key key, float x, float y) {
    const float fx = std::floor(x);
    const float fy = std::floor(y);
    const int ix = static_cast<int>(fx);
    const int iy = static_cast<int>(fy);
    const float dx = x - fx;
    const float dy = y - fy;
    return blend(corner(lattice_hash(key, ix, iy), dx, dy), corner(lattice_hash(key, ix + 1, iy), dx - 1, dy),
                 corner(lattice_hash(key, ix, iy + 1), dx, dy - 1),
                 corner(lattice_hash(key, ix + 1, iy + 1), dx - 1, dy - 1), dx, dy);
}

float gradient_tiled(Key key, float x, float y, int period) {
    const float fx = std::floor(x);
    const float fy = std::floor(y);
    const int x0 = wrapped(static_cast<int>(fx), period);
    const int y0 = wrapped(static_cast<int>(fy), period);
    const int x1 = x0 + 1 == period ? 0 : x0 + 1;
    const int y1 = y0 + 1 == period ? 0 : y0 + 1;
    const float dx = x - fx;
    const float dy = y - fy;
    return blend(corner(lattice_hash(key, x0, y0), dx, dy), corner(lattice_hash(key, x1, y0), dx - 1, dy),
                 corner(lattice_hash(key, x0, y1), dx, dy - 1), corner(lattice_hash(key, x1, y1), dx - 1, dy - 1), dx,
                 dy);
}

float fbm(Key key, float x, float y, const Octaves& octaves) {
    float sum = 0;
    float amplitude = 1;
    float total = 0;
    for (int i = 0; i < octaves.count; ++i) {
        sum += amplitude * shaped(gradient(key.octave(i), x, y), octaves.ridged);
        total += amplitude;
        amplitude *= octaves.gain;
        const float turned_x = octaves.lacunarity * (kCos * x - kSin * y);
        y = octaves.lacunarity * (kSin * x + kCos * y);
        x = turned_x;
    }
    return total > 0 ? sum / total : 0;
}

float fbm_tiled(Key key, float x, float y, int period, const Octaves& octaves) {
    float sum = 0;
    float amplitude = 1;
    float total = 0;
    int scale = 1;
    for (int i = 0; i < octaves.count; ++i) {
        const auto f = static_cast<float>(scale);
        sum += amplitude * shaped(gradient_tiled(key.octave(i), x * f, y * f, period * scale), octaves.ridged);
        total += amplitude;
        amplitude *= octaves.gain;
        scale *= 2;
    }
    return total > 0 ? sum / total : 0;
}

}  // namespace quadrat::synthesis::noise
