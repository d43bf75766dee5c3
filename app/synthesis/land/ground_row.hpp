// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <xsimd/xsimd.hpp>

// How the ground is painted, a row of pixels at a time, for any vector width: compiled once for the baseline and once
// for each wider instruction set, so nothing else may be included here and no function here has linkage.
namespace quadrat::synthesis::land {

// A material: its colour in OKLab, and its grain.
struct Material {
    float l = 0, a = 0, b = 0;
    float soft = 0, hard = 0;
};

// The materials and what decides where they lie.
struct GroundLook {
    Material dry, lush, heath, soil, scree, rock_dark, rock_light, mud, sand, gravel, snow;
    float lushness = 0, thirst = 0, heath_share = 0;
    float soil_slope = 0, scree_slope = 0, rock_slope = 0;
    float beds_per_m = 0, contrast = 0;
    float mud_share = 0, beach_top_m = 0;
    float snow_line_m = 0, snow_broken = 0, snow_aspect_m = 0, snow_slope = 0, snow_drift_m = 0;
    float fans = 0;
    float grain = 0, wet_top_m = 0;
};

// What the ground's colour hangs on, a value a pixel of one row; every row has room up to the next whole kMostLanes.
inline constexpr int kMostLanes = 16;
struct GroundRow {
    int width = 0;
    const float* height_m = nullptr;
    const float* shore_m = nullptr;  // height over the nearest water
    const float* slope = nullptr;    // rise over run
    const float* hollow = nullptr;   // more than 0 in hollows, less than 0 on ridges
    const float* moisture = nullptr;
    const float* shade = nullptr;   // slope toward the north, rise over run
    const float* road_m = nullptr;  // to the edge of a road
    const float* patch = nullptr;   // quiet large patches, about -1 to 1
    const float* grain = nullptr;   // fine variation, about -1 to 1
    // What comes of it: square roots of light times 4096, wetness and grains times 255, all ready to be cut to whole
    // numbers.
    float* red = nullptr;
    float* green = nullptr;
    float* blue = nullptr;
    float* wet = nullptr;
    float* soft = nullptr;  // how far its grain is that of grass and earth, how far that of stone
    float* hard = nullptr;
};

// The kernel, for vectors of Arch.
template <typename Arch>
struct GroundKernel {
    using F = xsimd::batch<float, Arch>;

    struct Lain {
        F l, a, b, soft, hard;
    };
    static F unit(F x) { return xsimd::min(xsimd::max(x, F(0.0F)), F(1.0F)); }
    static F smooth(float low, float high, F x) {
        const F t = unit((x - F(low)) * F(1.0F / (high - low)));
        return t * t * (F(3.0F) - F(2.0F) * t);
    }
    // A soft wave of period 2 in place of a sine: -1 to 1.
    static F wave(F x) {
        const F t = xsimd::abs(x - F(2.0F) * xsimd::floor(F(0.5F) * x) - F(1.0F));
        return F(2.0F) * t * t * (F(3.0F) - F(2.0F) * t) - F(1.0F);
    }
    static void lay(Lain& on, const Material& m, F w) {
        on.l = on.l + w * (F(m.l) - on.l);
        on.a = on.a + w * (F(m.a) - on.a);
        on.b = on.b + w * (F(m.b) - on.b);
        on.soft = on.soft + w * (F(m.soft) - on.soft);
        on.hard = on.hard + w * (F(m.hard) - on.hard);
    }
    static F root(F linear) { return F(4096.0F) * xsimd::sqrt(unit(linear)) + F(0.5F); }

    static void some(const GroundRow& row, const GroundLook& k, std::size_t i) {
        const auto at = [i](const float* values) { return F::load_unaligned(values + i); };
        const F h = at(row.height_m), shore = at(row.shore_m), s = at(row.slope), hollow = at(row.hollow);
        const F moist = at(row.moisture), p = at(row.patch), g = at(row.grain);
        // What grows: dry ground, greener where it is moist or hollow, heath in patches.
        Lain m{F(k.dry.l), F(k.dry.a), F(k.dry.b), F(k.dry.soft), F(k.dry.hard)};
        lay(m, k.lush,
            smooth(-0.9F, 0.9F, F(1.2F) * hollow + F(0.9F) * p + F(0.55F) * g + F(k.thirst) * moist + F(k.lushness)));
        lay(m, k.heath,
            F(k.heath_share) * smooth(0.25F, 0.7F, F(0.3F) * g - p) *
                (F(1.0F) - F(0.8F) * unit(F(1.6F) * moist - F(0.4F))));
        // What shows through where it is too steep to grow: earth, scree, then rock in beds. Crests are bare before
        // slopes are.
        const F steep = s - F(0.10F) * xsimd::min(hollow, F(0.0F));
        const F wander = F(0.5F) * p + F(0.35F) * g;
        lay(m, k.soil, smooth(k.soil_slope, k.soil_slope + 0.24F, steep + F(0.16F) * wander));
        lay(m, k.scree, smooth(k.scree_slope, k.scree_slope + 0.22F, steep + F(0.12F) * wander));
        // Fans spread where the ground grows less steep below it.
        lay(m, k.scree,
            F(k.fans) * smooth(0.26F, 0.4F, s + F(0.08F) * wander) * smooth(0.05F, 0.5F, hollow + F(0.35F) * p));
        const F rock = smooth(k.rock_slope, k.rock_slope + 0.31F, steep + F(0.10F) * wander);
        lay(m, k.rock_dark, rock);
        // Thick beds, and thin ones between.
        const F bed = F(k.beds_per_m) * h + p + F(0.45F) * g;
        const F beds = F(0.68F) * wave(bed) + F(0.42F) * wave(F(3.7F) * bed + F(0.5F) * p);
        lay(m, k.rock_light, unit(rock * (F(0.5F) + F(k.contrast) * beds)));
        // What lies on it: mud and sand by the water, a road's gravel, snow.
        lay(m, k.mud, F(k.mud_share) * smooth(0.75F, 1.0F, moist + F(0.15F) * p) * (F(1.0F) - smooth(0.12F, 0.3F, s)));
        const F beach_m = shore - F(k.beach_top_m) * (F(1.0F) + F(0.7F) * p + F(0.15F) * g);
        lay(m, k.sand, (F(1.0F) - smooth(0.0F, 0.9F * k.beach_top_m, beach_m)) * (F(1.0F) - smooth(0.5F, 0.8F, s)));
        // A dark verge on both sides is what tells a road from a strip of bare ground.
        const F road_m = at(row.road_m) + F(0.3F) * g;
        lay(m, k.mud, F(0.6F) * smooth(0.2F, 0.8F, road_m) * (F(1.0F) - smooth(1.4F, 3.0F, road_m)));
        lay(m, k.gravel, F(0.95F) - F(0.95F) * smooth(-0.3F, 0.6F, road_m));
        const F shady = xsimd::min(xsimd::max(at(row.shade), F(-0.6F)), F(0.6F));
        const F over_snow_m = h - F(k.snow_line_m) + F(k.snow_aspect_m) * shady + F(5.0F + k.snow_drift_m) * hollow;
        // It ends at an edge: above it lies or slides off, it does not thin.
        lay(m, k.snow,
            smooth(-2.2F, 2.8F, over_snow_m + F(k.snow_broken) * (F(7.0F) * p + F(5.0F) * g) + F(1.0F) * g) *
                (F(1.0F) - smooth(k.snow_slope + 0.02F, k.snow_slope + 0.10F,
                                  s + F(0.14F) * g + F(0.03F) * p - F(0.12F) * hollow)));
        finish(row, k, i, m, shore, g, p);
    }

    static void finish(const GroundRow& row, const GroundLook& k, std::size_t i, Lain& m, F shore, F g, F p) {
        // Grain as strong everywhere would be a carpet.
        const F strong = F(0.95F) + F(0.4F) * xsimd::min(xsimd::max(p, F(-1.0F)), F(1.0F));
        // Wet ground is darker and of a deeper colour.
        const F wet = F(1.0F) - smooth(0.15F * k.wet_top_m, k.wet_top_m, shore + F(0.1F * k.wet_top_m) * g);
        m.l = m.l * (F(1.0F) + F(k.grain) * g) * (F(1.0F) - F(0.20F) * wet);
        const F deeper = F(1.0F) + F(0.10F) * wet;
        m.a = m.a * deeper;
        m.b = m.b * deeper;
        const auto put = [i](float* values, F x) { x.store_unaligned(values + i); };
        put(row.soft, F(255.0F) * unit(strong * m.soft * (F(1.0F) - F(0.25F) * wet)) + F(0.5F));
        put(row.hard, F(255.0F) * unit(strong * m.hard) + F(0.5F));
        // scene::linear_from_oklab.
        const F l_ = m.l + F(0.3963377774F) * m.a + F(0.2158037573F) * m.b;
        const F m_ = m.l - F(0.1055613458F) * m.a - F(0.0638541728F) * m.b;
        const F s_ = m.l - F(0.0894841775F) * m.a - F(1.2914855480F) * m.b;
        const F lc = l_ * l_ * l_;
        const F mc = m_ * m_ * m_;
        const F sc = s_ * s_ * s_;
        put(row.red, root(F(4.0767416621F) * lc - F(3.3077115913F) * mc + F(0.2309699292F) * sc));
        put(row.green, root(F(-1.2684380046F) * lc + F(2.6097574011F) * mc - F(0.3413193965F) * sc));
        put(row.blue, root(F(-0.0041960863F) * lc - F(0.7034186147F) * mc + F(1.7076147010F) * sc));
        put(row.wet, F(255.0F) * (F(1.0F) - smooth(0.15F, 0.9F, shore)));
    }

    static void paint(const GroundRow& row, const GroundLook& look) {
        const auto width = static_cast<std::size_t>(row.width);
        for (std::size_t i = 0; i < width; i += F::size) some(row, look, i);
    }
};

namespace {

// Between two rows of samples and between their samples: out[i] lies share[i] past sample first[i].
inline void interpolate_ground_row(const float* above, const float* below, float down, int samples,
                                   const std::int32_t* __restrict first, const float* __restrict share, int width,
                                   float* __restrict between, float* __restrict out) {
    for (int i = 0; i < samples; ++i) between[i] = above[i] + down * (below[i] - above[i]);
    for (int i = 0; i < width; ++i) {
        const float left = between[first[i]];
        out[i] = left + share[i] * (between[first[i] + 1] - left);
    }
}

}  // namespace

#if defined(__x86_64__)
void paint_ground_row_avx2(const GroundRow& row, const GroundLook& look);
void interpolate_ground_row_avx2(const float* above, const float* below, float down, int samples,
                                 const std::int32_t* first, const float* share, int width, float* between, float* out);
#endif

}  // namespace quadrat::synthesis::land
