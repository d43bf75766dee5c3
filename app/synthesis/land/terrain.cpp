// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/terrain.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace quadrat::synthesis::land {
namespace {

constexpr float kHalfSide_m = 512.0F;

float smooth(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

}  // namespace

Terrain::Terrain(const scene::LandParameters& parameters, base::Seed seed)
    : parameters_(parameters), hills_(seed.child("hills")), bends_(seed.child("bends")), range_(seed.child("range")) {
    base::RandomStream random{seed.child("terrain")};
    rugged_ = smooth(0.38F, 0.56F, parameters.gain);
    // Hills no steeper than a place one could stand in, however small they are.
    noise_relief_m_ = std::min(0.62F * parameters.relief_m, 0.30F * parameters.feature_size_m);
    form_relief_m_ = 0.75F * parameters.relief_m;
    valley_phase_ = random.between(-0.5F, 0.5F);
    sea_m_ = sea_level_m();
}

// The level that covers the wished share of the land, from a sparse sample of it.
float Terrain::sea_level_m() const {
    constexpr int kSide = 40;
    std::vector<float> xs_m(kSide);
    std::vector<float> row_m(kSide);
    std::vector<float> all_m;
    for (int i = 0; i < kSide; ++i) xs_m[i] = kHalfSide_m * (2.0F * (static_cast<float>(i) + 0.5F) / kSide - 1.0F);
    for (const float z_m : xs_m) {
        above_lowest_m(xs_m, z_m, 16.0F, row_m);
        all_m.insert(all_m.end(), row_m.begin(), row_m.end());
    }
    const float share = std::clamp(parameters_.sea_level, 0.0F, 0.9F);
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<float>(all_m.size() - 1));
    std::nth_element(all_m.begin(), all_m.begin() + rank, all_m.end());
    return all_m[rank] - 1.0F;
}

// What closes the picture: rising beyond the land, highest about three kilometres out, higher in the north.
void Terrain::add_ranges(std::span<const float> xs_m, float z_m, std::span<float> out) const {
    const float height_m = 70.0F + 1.15F * parameters_.relief_m;
    for (std::size_t i = 0; i < xs_m.size(); ++i) {
        const float x_m = xs_m[i];
        const float out_m = std::sqrt(x_m * x_m + z_m * z_m);
        const float rise = smooth(700.0F, 3200.0F, out_m);
        if (rise <= 0) continue;
        const float fall = 1.0F - 0.55F * smooth(3600.0F, 8000.0F, out_m);
        const float ridge = noise::fbm(range_, x_m / 2300.0F, z_m / 2300.0F,
                                       {.count = 5, .gain = 0.45F, .ridged = 0.35F + 0.5F * rugged_});
        const float toward_north = 0.75F + 0.35F * (-z_m / out_m);
        out[i] += rise * fall * toward_north * height_m * std::max(0.0F, 0.42F + 1.15F * ridge);
    }
}

void Terrain::above_lowest_m(std::span<const float> xs_m, float z_m, float cell_m, std::span<float> out) const {
    int octaves = 1;
    for (float wave_m = parameters_.feature_size_m; wave_m > 2.5F * cell_m && octaves < 9; wave_m *= 0.5F) ++octaves;
    std::vector<float> us(xs_m.size());
    for (std::size_t i = 0; i < xs_m.size(); ++i) us[i] = xs_m[i] / parameters_.feature_size_m;
    const std::vector<float> vs(xs_m.size(), z_m / parameters_.feature_size_m);
    noise::fbm(hills_, us, vs, out, {.count = octaves, .gain = parameters_.gain, .ridged = 0.75F * rugged_});

    // 0 in the hollow to 1 on the heights; u east, v south, 1 at the land's edge.
    const float v = z_m / kHalfSide_m;
    const float bend = valley_phase_ * (0.55F - v) + 0.45F * noise::gradient(bends_, 0.8F * v + 7.3F, 0.37F);
    const float north = 0.34F * smooth(-0.1F, -1.7F, v);
    const float flank_share = 0.62F * (0.55F + 0.45F * smooth(0.9F, -0.6F, v));
    const float dv = v - 0.66F;
    const float knoll_share = 0.36F * std::exp(-dv * dv / 0.16F);
    for (std::size_t i = 0; i < xs_m.size(); ++i) {
        const float u = xs_m[i] / kHalfSide_m;
        const float aside = (u - bend) / 0.62F;
        const float flank = 1.0F - 1.0F / (1.0F + aside * aside);
        const float beside = 1.0F + 1.6F * u * u;  // about a bell's shape, cheaper
        const float form = 0.10F + flank_share * flank + north + knoll_share / (beside * beside);
        // Hills grow out of the heights; the hollow stays calm.
        const float swing = 0.35F + 0.65F * std::min(form, 1.2F);
        out[i] = form_relief_m_ * form + 1.25F * noise_relief_m_ * swing * out[i];
    }
    add_ranges(xs_m, z_m, out);
}

void Terrain::heights_m(std::span<const float> xs_m, float z_m, float cell_m, std::span<float> out) const {
    above_lowest_m(xs_m, z_m, cell_m, out);
    for (float& h : out) h -= sea_m_;
}

}  // namespace quadrat::synthesis::land
