// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <xsimd/xsimd.hpp>

// The kernels of gradient.hpp, for any vector width. Compiled once for the baseline and once for each wider instruction
// set; nothing else may be included here, so that no code of a wider set escapes into the rest of the program.
namespace quadrat::synthesis::noise::kernel {

inline constexpr std::uint32_t kPrimeX = 0x1E35A7BDU;
inline constexpr std::uint32_t kPrimeY = 0x5851F42DU;
inline constexpr std::uint32_t kMixer = 0x27D4EB2DU;
inline constexpr std::uint32_t kOctaveStep = 0x9E3779B9U;
inline constexpr float kUnit = 1.0F / 2147483648.0F;
inline constexpr float kScale = 1.5F;  // brings the deviation to about 0.3
// A turn by 36.87 degrees, exact in its digits (3-4-5), between octaves.
inline constexpr float kCos = 0.8F;
inline constexpr float kSin = 0.6F;

struct Sum {
    std::uint32_t key;
    int count;
    float gain;
    float ridged;
    float lacunarity;
    float scale;  // of the sum
    int period;   // of the first octave when tiled; 0: not tiled
};

template <typename Arch>
struct Kernel {
    using F = xsimd::batch<float, Arch>;
    using I = xsimd::batch<std::int32_t, Arch>;
    using U = xsimd::batch<std::uint32_t, Arch>;
    static constexpr std::size_t kLanes = F::size;

    // The gradient's components are uniform over [-1, 1): its covariance is round, and one shift makes both.
    static F corner(U primed, F dx, F dy) {
        U h = primed * U(kMixer);
        h = h ^ (h >> 15);
        const F gx = xsimd::to_float(xsimd::bitwise_cast<I>(h << 16));
        const F gy = xsimd::to_float(xsimd::bitwise_cast<I>(h));
        return gx * dx + gy * dy;
    }

    static F fade(F t) { return t * t * t * (t * (t * F(6.0F) - F(15.0F)) + F(10.0F)); }

    static F blend(U key, U x0, U x1, U y0, U y1, F dx, F dy) {
        const F ex = dx - F(1.0F);
        const F ey = dy - F(1.0F);
        const U above_key = key ^ y0;
        const U below_key = key ^ y1;
        const F u = fade(dx);
        const F n00 = corner(above_key ^ x0, dx, dy);
        const F n10 = corner(above_key ^ x1, ex, dy);
        const F n01 = corner(below_key ^ x0, dx, ey);
        const F n11 = corner(below_key ^ x1, ex, ey);
        const F above = n00 + u * (n10 - n00);
        const F below = n01 + u * (n11 - n01);
        return F(kScale * kUnit) * (above + fade(dy) * (below - above));
    }

    static F gradient(std::uint32_t key, F x, F y) {
        const F fx = xsimd::floor(x);
        const F fy = xsimd::floor(y);
        const U x0 = xsimd::bitwise_cast<U>(xsimd::to_int(fx)) * U(kPrimeX);
        const U y0 = xsimd::bitwise_cast<U>(xsimd::to_int(fy)) * U(kPrimeY);
        return blend(U(key), x0, x0 + U(kPrimeX), y0, y0 + U(kPrimeY), x - fx, y - fy);
    }

    // x and y in [0, period).
    static F gradient_tiled(std::uint32_t key, F x, F y, int period) {
        const F fx = xsimd::floor(x);
        const F fy = xsimd::floor(y);
        const I x0 = xsimd::to_int(fx);
        const I y0 = xsimd::to_int(fy);
        const I last(period - 1);
        const I x1 = xsimd::select(x0 == last, I(0), x0 + I(1));
        const I y1 = xsimd::select(y0 == last, I(0), y0 + I(1));
        const auto primed = [](I i, std::uint32_t prime) { return xsimd::bitwise_cast<U>(i) * U(prime); };
        return blend(U(key), primed(x0, kPrimeX), primed(x1, kPrimeX), primed(y0, kPrimeY), primed(y1, kPrimeY), x - fx,
                     y - fy);
    }

    static F octaves(const Sum& s, F x, F y) {
        F sum(0.0F);
        float amplitude = 1;
        std::uint32_t key = s.key;
        for (int i = 0; i < s.count; ++i) {
            key += kOctaveStep;
            const F n = gradient(key, x, y);
            sum = sum + F(amplitude) * (n + F(s.ridged) * (F(1.0F) - F(2.0F) * xsimd::abs(n) - n));
            amplitude *= s.gain;
            const F turned = F(s.lacunarity) * (F(kCos) * x - F(kSin) * y);
            y = F(s.lacunarity) * (F(kSin) * x + F(kCos) * y);
            x = turned;
        }
        return F(s.scale) * sum;
    }

    static F octaves_tiled(const Sum& s, F x, F y) {
        F sum(0.0F);
        float amplitude = 1;
        std::uint32_t key = s.key;
        int period = s.period;
        for (int i = 0; i < s.count; ++i) {
            key += kOctaveStep;
            const F n = gradient_tiled(key, x, y, period);
            sum = sum + F(amplitude) * (n + F(s.ridged) * (F(1.0F) - F(2.0F) * xsimd::abs(n) - n));
            amplitude *= s.gain;
            period *= 2;
            x = x * F(2.0F);
            y = y * F(2.0F);
        }
        return F(s.scale) * sum;
    }

    static void run(const Sum& s, const float* xs, const float* ys, float* out, std::size_t count) {
        const auto some = [&s](F x, F y) { return s.period > 0 ? octaves_tiled(s, x, y) : octaves(s, x, y); };
        std::size_t i = 0;
        for (; i + kLanes <= count; i += kLanes)
            some(F::load_unaligned(xs + i), F::load_unaligned(ys + i)).store_unaligned(out + i);
        if (i == count) return;
        float rest[3][kLanes] = {};
        for (std::size_t k = i; k < count; ++k) {
            rest[0][k - i] = xs[k];
            rest[1][k - i] = ys[k];
        }
        some(F::load_unaligned(rest[0]), F::load_unaligned(rest[1])).store_unaligned(rest[2]);
        for (std::size_t k = i; k < count; ++k) out[k] = rest[2][k - i];
    }
};

#if defined(__x86_64__)
void run_avx2(const Sum& sum, const float* xs, const float* ys, float* out, std::size_t count);
#endif

}  // namespace quadrat::synthesis::noise::kernel
