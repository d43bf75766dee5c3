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

// The order of Basis and Mix in gradient.hpp; Folded is a Sum with a share of ridges.
enum class Base : int { Gradient, Simplex, Value, Cells, Cracks };
enum class Law : int { Sum, Ridged, Hybrid, Hetero, Folded };

struct Sum {
    Base base;
    Law law;
    std::uint32_t key;
    int count;
    float gain;
    float ridged;
    float lacunarity;
    float scale;   // of the sum
    float middle;  // what is taken off it first
    int period;    // of the first octave when tiled; 0: not tiled
};

// The same bits as another vector: xsimd 8 is told the vector, later ones its element.
template <typename To, typename From>
To bits_as(const From& from) {
#if XSIMD_VERSION_MAJOR >= 9
    return xsimd::bitwise_cast<typename To::value_type>(from);
#else
    return xsimd::bitwise_cast<To>(from);
#endif
}

template <typename Arch>
struct Kernel {
    using F = xsimd::batch<float, Arch>;
    using I = xsimd::batch<std::int32_t, Arch>;
    using U = xsimd::batch<std::uint32_t, Arch>;
    static constexpr std::size_t kLanes = F::size;

    // The gradient's components are uniform over [-1, 1): its covariance is round, and one shift makes both.
    static F corner(U primed, F dx, F dy) {
        U h = (primed ^ (primed >> 16)) * U(kMixer);
        h = h ^ (h >> 15);
        const F gx = xsimd::to_float(bits_as<I>(h << 16));
        const F gy = xsimd::to_float(bits_as<I>(h));
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
        const U x0 = bits_as<U>(xsimd::to_int(fx)) * U(kPrimeX);
        const U y0 = bits_as<U>(xsimd::to_int(fy)) * U(kPrimeY);
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
        const auto primed = [](I i, std::uint32_t prime) { return bits_as<U>(i) * U(prime); };
        return blend(U(key), primed(x0, kPrimeX), primed(x1, kPrimeX), primed(y0, kPrimeY), primed(y1, kPrimeY), x - fx,
                     y - fy);
    }

    static U hashed(U primed) {
        U h = (primed ^ (primed >> 16)) * U(kMixer);
        h = h ^ (h >> 15);
        return h * U(kMixer);
    }
    static F signed_unit(U h) { return xsimd::to_float(bits_as<I>(h)) * F(kUnit); }

    // A value a lattice point, blended; -1 to 1.
    static F value(std::uint32_t key, F x, F y) {
        const F fx = xsimd::floor(x);
        const F fy = xsimd::floor(y);
        const U x0 = bits_as<U>(xsimd::to_int(fx)) * U(kPrimeX);
        const U y0 = bits_as<U>(xsimd::to_int(fy)) * U(kPrimeY);
        const U x1 = x0 + U(kPrimeX);
        const U y1 = y0 + U(kPrimeY);
        const F u = fade(x - fx);
        const U k(key);
        const F n00 = signed_unit(hashed(k ^ y0 ^ x0));
        const F n10 = signed_unit(hashed(k ^ y0 ^ x1));
        const F n01 = signed_unit(hashed(k ^ y1 ^ x0));
        const F n11 = signed_unit(hashed(k ^ y1 ^ x1));
        const F above = n00 + u * (n10 - n00);
        const F below = n01 + u * (n11 - n01);
        return above + fade(y - fy) * (below - above);
    }

    // Perlin's simplex grid, 2001: three corners of a skewed cell, each with a round kernel.
    static F simplex(std::uint32_t key, F x, F y) {
        const F kSkew(0.36602540F);    // (sqrt 3 - 1) / 2
        const F kUnskew(0.21132487F);  // (3 - sqrt 3) / 6
        const F s = (x + y) * kSkew;
        const F i = xsimd::floor(x + s);
        const F j = xsimd::floor(y + s);
        const F t = (i + j) * kUnskew;
        const F dx = x - (i - t);
        const F dy = y - (j - t);
        const auto is_lower = dx > dy;
        const F one(1.0F);
        const F step_x = xsimd::select(is_lower, one, F(0.0F));
        const F step_y = one - step_x;
        const U x0 = bits_as<U>(xsimd::to_int(i)) * U(kPrimeX);
        const U y0 = bits_as<U>(xsimd::to_int(j)) * U(kPrimeY);
        const U mid_x = bits_as<U>(xsimd::to_int(i + step_x)) * U(kPrimeX);
        const U mid_y = bits_as<U>(xsimd::to_int(j + step_y)) * U(kPrimeY);
        const auto kernel = [](U primed, F ex, F ey) {
            const F r = F(0.5F) - ex * ex - ey * ey;
            const F k = xsimd::max(r, F(0.0F));
            return k * k * k * k * corner(primed, ex, ey);
        };
        const U k(key);
        const F last = F(1.0F) - F(2.0F) * kUnskew;
        return F(62.0F * kUnit) *
               (kernel(k ^ x0 ^ y0, dx, dy) + kernel(k ^ mid_x ^ mid_y, dx - step_x + kUnskew, dy - step_y + kUnskew) +
                kernel(k ^ (x0 + U(kPrimeX)) ^ (y0 + U(kPrimeY)), dx - last, dy - last));
    }

    // Worley 1996: the distances to the nearest and the second nearest of one point a cell.
    struct Nearest {
        F first, second;
    };
    static Nearest nearest(std::uint32_t key, F x, F y) {
        const F fx = xsimd::floor(x);
        const F fy = xsimd::floor(y);
        const U x0 = bits_as<U>(xsimd::to_int(fx)) * U(kPrimeX);
        const U y0 = bits_as<U>(xsimd::to_int(fy)) * U(kPrimeY);
        Nearest d{F(8.0F), F(8.0F)};
        for (int j = -1; j <= 1; ++j) {
            for (int i = -1; i <= 1; ++i) {
                const U h = hashed(U(key) ^ (x0 + U(kPrimeX * static_cast<std::uint32_t>(i))) ^
                                   (y0 + U(kPrimeY * static_cast<std::uint32_t>(j))));
                const F px = fx + F(static_cast<float>(i) + 0.5F) + F(0.45F) * signed_unit(h);
                const F py = fy + F(static_cast<float>(j) + 0.5F) + F(0.45F) * signed_unit(h << 16);
                const F r = (px - x) * (px - x) + (py - y) * (py - y);
                d.second = xsimd::min(d.second, xsimd::max(d.first, r));
                d.first = xsimd::min(d.first, r);
            }
        }
        return {xsimd::sqrt(d.first), xsimd::sqrt(d.second)};
    }

    template <Base B>
    static F basis(std::uint32_t key, F x, F y) {
        if constexpr (B == Base::Simplex) return simplex(key, x, y);
        if constexpr (B == Base::Value) return value(key, x, y);
        if constexpr (B == Base::Cells) return F(1.0F) - F(1.8F) * nearest(key, x, y).first;
        if constexpr (B == Base::Cracks) {
            const Nearest d = nearest(key, x, y);
            return F(2.0F) * (d.second - d.first) - F(0.7F);
        }
        return gradient(key, x, y);
    }

    // Musgrave's multifractals, "Texturing and Modeling" 1994 (3rd ed. 2003, chapter 16), with gain for 2^-H.
    template <Base B, Law L>
    static F multifractal(const Sum& s, F x, F y) {
        std::uint32_t key = s.key;
        float amplitude = 1;
        F sum(0.0F);
        F weight(1.0F);
        for (int i = 0; i < s.count; ++i) {
            key += kOctaveStep;
            const F n = basis<B>(key, x, y);
            if constexpr (L == Law::Sum) sum = sum + F(amplitude) * n;
            if constexpr (L == Law::Folded)
                sum = sum + F(amplitude) * (n + F(s.ridged) * (F(1.0F) - F(2.0F) * xsimd::abs(n) - n));
            if constexpr (L == Law::Ridged) {
                const F ridge = F(1.0F) - xsimd::abs(n);
                const F signal = ridge * ridge * weight;
                sum = sum + F(amplitude) * signal;
                weight = xsimd::min(xsimd::max(signal * F(2.0F), F(0.0F)), F(1.0F));
            }
            if constexpr (L == Law::Hybrid) {
                const F signal = (n + F(0.7F)) * F(amplitude);
                weight = xsimd::min(weight, F(1.0F));
                sum = sum + weight * signal;
                weight = i == 0 ? signal : weight * signal;
            }
            if constexpr (L == Law::Hetero) {
                const F raised = (n + F(1.0F)) * F(amplitude);
                sum = i == 0 ? raised : sum + raised * sum;
            }
            amplitude *= s.gain;
            const F turned = F(s.lacunarity * kCos) * x - F(s.lacunarity * kSin) * y;
            y = F(s.lacunarity * kSin) * x + F(s.lacunarity * kCos) * y;
            x = turned;
        }
        return F(s.scale) * (sum - F(s.middle));
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

    template <typename Some>
    static void run_all(const Some& some, const float* xs, const float* ys, float* out, std::size_t count) {
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

    template <Base B, Law L>
    static void run_as(const Sum& s, const float* xs, const float* ys, float* out, std::size_t count) {
        run_all([&s](F x, F y) { return multifractal<B, L>(s, x, y); }, xs, ys, out, count);
    }

    template <Base B>
    static void run_on(const Sum& s, const float* xs, const float* ys, float* out, std::size_t count) {
        switch (s.law) {
            case Law::Sum:
                if (s.ridged == 0) return run_as<B, Law::Sum>(s, xs, ys, out, count);
                [[fallthrough]];
            case Law::Folded:
                return run_as<B, Law::Folded>(s, xs, ys, out, count);
            case Law::Ridged:
                return run_as<B, Law::Ridged>(s, xs, ys, out, count);
            case Law::Hybrid:
                return run_as<B, Law::Hybrid>(s, xs, ys, out, count);
            case Law::Hetero:
                return run_as<B, Law::Hetero>(s, xs, ys, out, count);
        }
    }

    static void run(const Sum& s, const float* xs, const float* ys, float* out, std::size_t count) {
        if (s.period > 0) return run_all([&s](F x, F y) { return octaves_tiled(s, x, y); }, xs, ys, out, count);
        switch (s.base) {
            case Base::Gradient:
                return run_on<Base::Gradient>(s, xs, ys, out, count);
            case Base::Simplex:
                return run_on<Base::Simplex>(s, xs, ys, out, count);
            case Base::Value:
                return run_on<Base::Value>(s, xs, ys, out, count);
            case Base::Cells:
                return run_on<Base::Cells>(s, xs, ys, out, count);
            case Base::Cracks:
                return run_on<Base::Cracks>(s, xs, ys, out, count);
        }
    }
};

#if defined(__x86_64__)
void run_avx2(const Sum& sum, const float* xs, const float* ys, float* out, std::size_t count);
#endif

}  // namespace quadrat::synthesis::noise::kernel
