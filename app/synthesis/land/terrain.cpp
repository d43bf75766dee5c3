// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/terrain.hpp"

#include <algorithm>
#include <cmath>

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
    sea_m_ = parameters.sea_level * parameters.relief_m;
    valley_phase_ = random.between(-0.5F, 0.5F);
}

// 0 in the hollow to 1 on the heights; u east, v south, 1 at the land's edge.
float Terrain::composed(float u, float v) const {
    const float bend = valley_phase_ * (0.55F - v) + 0.45F * noise::gradient(bends_, 0.8F * v + 7.3F, 0.37F);
    const float aside = (u - bend) / 0.62F;
    const float flank = 1.0F - 1.0F / (1.0F + aside * aside);
    const float north = smooth(-0.1F, -1.7F, v);
    const float dv = v - 0.66F;
    const float knoll = std::exp(-(u * u + dv * dv) / 0.16F);
    return 0.10F + 0.62F * flank * (0.55F + 0.45F * smooth(0.9F, -0.6F, v)) + 0.34F * north + 0.36F * knoll;
}

// What closes the picture: rising beyond the land, highest about three kilometres out, higher in the north.
float Terrain::ranges_m(float x_m, float z_m) const {
    const float out_m = std::sqrt(x_m * x_m + z_m * z_m);
    const float rise = smooth(700.0F, 3200.0F, out_m);
    if (rise <= 0) return 0;
    const float fall = 1.0F - 0.55F * smooth(3600.0F, 8000.0F, out_m);
    const float ridge =
        noise::fbm(range_, x_m / 2300.0F, z_m / 2300.0F, {.count = 5, .gain = 0.45F, .ridged = 0.35F + 0.5F * rugged_});
    const float toward_north = 0.75F + 0.35F * (-z_m / std::max(out_m, 1.0F));
    const float height_m = 70.0F + 1.15F * parameters_.relief_m;
    return rise * fall * toward_north * height_m * std::max(0.0F, 0.42F + 1.15F * ridge);
}

float Terrain::height_m(float x_m, float z_m) const { return height_m(x_m, z_m, 2.0F); }

float Terrain::height_m(float x_m, float z_m, float cell_m) const {
    int octaves = 1;
    for (float wave_m = parameters_.feature_size_m; wave_m > 2.5F * cell_m && octaves < 9; wave_m *= 0.5F) ++octaves;
    const float hills = noise::fbm(hills_, x_m / parameters_.feature_size_m, z_m / parameters_.feature_size_m,
                                   {.count = octaves, .gain = parameters_.gain, .ridged = 0.75F * rugged_});
    const float form = composed(x_m / kHalfSide_m, z_m / kHalfSide_m);
    // Hills grow out of the heights; the hollow stays calm.
    const float swing = 0.35F + 0.65F * std::min(form, 1.2F);
    return form_relief_m_ * form + 1.25F * noise_relief_m_ * swing * hills + ranges_m(x_m, z_m) - sea_m_;
}

}  // namespace quadrat::synthesis::land
