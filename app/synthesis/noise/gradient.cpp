// SPDX-License-Identifier: Apache-2.0
#include "synthesis/noise/gradient.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "synthesis/noise/gradient_kernel.hpp"

namespace quadrat::synthesis::noise {
namespace {

using kernel::kPrimeX;
using kernel::kPrimeY;

// The kernel of gradient_kernel.hpp for one point, operation for operation.
float corner(std::uint32_t primed, float dx, float dy) {
    std::uint32_t h = (primed ^ (primed >> 16U)) * kernel::kMixer;
    h ^= h >> 15U;
    const auto gx = static_cast<float>(static_cast<std::int32_t>(h << 16U));
    const auto gy = static_cast<float>(static_cast<std::int32_t>(h));
    return gx * dx + gy * dy;
}

float fade(float t) { return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F); }

struct Cell {
    std::uint32_t x0, x1, y0, y1;
    float dx, dy;
};

float blend(std::uint32_t key, const Cell& c) {
    const float n00 = corner(key ^ c.y0 ^ c.x0, c.dx, c.dy);
    const float n10 = corner(key ^ c.y0 ^ c.x1, c.dx - 1.0F, c.dy);
    const float n01 = corner(key ^ c.y1 ^ c.x0, c.dx, c.dy - 1.0F);
    const float n11 = corner(key ^ c.y1 ^ c.x1, c.dx - 1.0F, c.dy - 1.0F);
    const float u = fade(c.dx);
    const float above = n00 + u * (n10 - n00);
    const float below = n01 + u * (n11 - n01);
    return kernel::kScale * kernel::kUnit * (above + fade(c.dy) * (below - above));
}

float gradient_at(std::uint32_t key, float x, float y) {
    const float fx = std::floor(x);
    const float fy = std::floor(y);
    const std::uint32_t x0 = static_cast<std::uint32_t>(static_cast<std::int32_t>(fx)) * kPrimeX;
    const std::uint32_t y0 = static_cast<std::uint32_t>(static_cast<std::int32_t>(fy)) * kPrimeY;
    return blend(key, {x0, x0 + kPrimeX, y0, y0 + kPrimeY, x - fx, y - fy});
}

kernel::Sum sum_of(Key key, const Octaves& octaves, int period) {
    float total = 0;
    float amplitude = 1;
    for (int i = 0; i < octaves.count; ++i) {
        total += amplitude;
        amplitude *= octaves.gain;
    }
    kernel::Sum sum{static_cast<kernel::Base>(octaves.basis),
                    static_cast<kernel::Law>(octaves.mix),
                    key.value,
                    octaves.count,
                    octaves.gain,
                    octaves.ridged,
                    octaves.lacunarity,
                    total > 0 ? 1.0F / total : 0.0F,
                    0,
                    period};
    // Middles and ranges of the multifractals, found by measuring.
    if (octaves.mix == Mix::Ridged) {
        sum.middle = 0.62F * total;
        sum.scale *= 1.7F;
    } else if (octaves.mix == Mix::Hybrid) {
        sum.middle = 0.7F + 0.28F * (total - 1.0F);
        sum.scale = 1.0F / (0.7F + 0.5F * total);
    } else if (octaves.mix == Mix::Hetero) {
        sum.middle = 1.0F;
        for (float a = octaves.gain;
             sum.middle < 1.0e6F && a > std::pow(octaves.gain, static_cast<float>(octaves.count) - 0.5F);
             a *= octaves.gain)
            sum.middle *= 1.0F + a;
        sum.scale = 0.8F / sum.middle;
    }
    return sum;
}

void run(const kernel::Sum& sum, std::span<const float> xs, std::span<const float> ys, std::span<float> out) {
    assert(xs.size() == out.size() && ys.size() == out.size());
#if defined(__x86_64__)
    static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
    if (has_avx2) return kernel::run_avx2(sum, xs.data(), ys.data(), out.data(), out.size());
#endif
    kernel::Kernel<xsimd::default_arch>::run(sum, xs.data(), ys.data(), out.data(), out.size());
}

}  // namespace

float gradient(Key key, float x, float y) { return gradient_at(key.value, x, y); }

float fbm(Key key, float x, float y, const Octaves& octaves) {
    const kernel::Sum s = sum_of(key, octaves, 0);
    if (octaves.basis != Basis::Gradient || octaves.mix != Mix::Sum) {
        float out = 0;
        run(s, {&x, 1}, {&y, 1}, {&out, 1});
        return out;
    }
    float sum = 0;
    float amplitude = 1;
    std::uint32_t octave_key = s.key;
    for (int i = 0; i < s.count; ++i) {
        octave_key += kernel::kOctaveStep;
        const float n = gradient_at(octave_key, x, y);
        sum = sum + amplitude * (n + s.ridged * (1.0F - 2.0F * std::abs(n) - n));
        amplitude *= s.gain;
        const float turned = s.lacunarity * kernel::kCos * x - s.lacunarity * kernel::kSin * y;
        y = s.lacunarity * kernel::kSin * x + s.lacunarity * kernel::kCos * y;
        x = turned;
    }
    return s.scale * sum;
}

void fbm(Key key, std::span<const float> xs, std::span<const float> ys, std::span<float> out, const Octaves& octaves) {
    run(sum_of(key, octaves, 0), xs, ys, out);
}

float mixed(std::span<const float> values, const Octaves& octaves) {
    const kernel::Sum s = sum_of(Key(0U), octaves, 0);
    float amplitude = 1;
    float sum = 0;
    float weight = 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float n = values[i];
        if (octaves.mix == Mix::Sum) sum += amplitude * (n + s.ridged * (1.0F - 2.0F * std::abs(n) - n));
        if (octaves.mix == Mix::Ridged) {
            const float ridge = 1.0F - std::abs(n);
            const float signal = ridge * ridge * weight;
            sum += amplitude * signal;
            weight = std::clamp(2.0F * signal, 0.0F, 1.0F);
        }
        if (octaves.mix == Mix::Hybrid) {
            const float signal = (n + 0.7F) * amplitude;
            weight = std::min(weight, 1.0F);
            sum += weight * signal;
            weight = i == 0 ? signal : weight * signal;
        }
        if (octaves.mix == Mix::Hetero) {
            const float raised = (n + 1.0F) * amplitude;
            sum = i == 0 ? raised : sum + raised * sum;
        }
        amplitude *= s.gain;
    }
    return s.scale * (sum - s.middle);
}

float fbm_tiled(Key key, float x, float y, int period, const Octaves& octaves) {
    float out = 0;
    run(sum_of(key, octaves, period), {&x, 1}, {&y, 1}, {&out, 1});
    return out;
}

void fbm_tiled(Key key, std::span<const float> xs, std::span<const float> ys, std::span<float> out, int period,
               const Octaves& octaves) {
    run(sum_of(key, octaves, period), xs, ys, out);
}

}  // namespace quadrat::synthesis::noise
