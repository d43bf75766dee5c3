// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/terrain.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "scene/land_parameters.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr float kHalfSide_m = 512.0F;
constexpr float kHighestRange = 0.16F;  // to its distance

}  // namespace

Terrain::Terrain(const scene::LandParameters& parameters, base::Seed seed)
    : parameters_(parameters),
      landforms_(parameters, seed),
      hills_(seed.child("hills")),
      folds_(seed.child("folds")),
      bends_(seed.child("bends")),
      range_(seed.child("range")) {
    base::RandomStream random{seed.child("terrain")};
    rugged_ = glm::smoothstep(0.38F, 0.56F, parameters.land_gain);
    form_relief_m_ = parameters.form_share * parameters.land_relief_m;
    // Hills no steeper than a place one could stand in, however small they are.
    noise_relief_m_ = std::min((1.37F - parameters.form_share) * parameters.land_relief_m,
                               parameters.hill_steepness * parameters.land_feature_size_m);
    valley_phase_ = random.between(-0.5F, 0.5F) + parameters.form_valley_slant;
    sea_m_ = sea_level_m();
}

// The level that covers the wished share of the land, from a sparse sample of it; where the viewer stands stays dry.
float Terrain::sea_level_m() const {
    constexpr int kSide = 40;
    std::vector<float> xs_m(kSide);
    std::vector<float> row_m(kSide);
    std::vector<float> all_m;
    std::vector<float> knoll_m;
    for (int i = 0; i < kSide; ++i) xs_m[i] = kHalfSide_m * (2.0F * (static_cast<float>(i) + 0.5F) / kSide - 1.0F);
    for (const float z_m : xs_m) {
        above_lowest_m(xs_m, z_m, 16.0F, row_m);
        all_m.insert(all_m.end(), row_m.begin(), row_m.end());
        for (int i = 0; i < kSide && z_m > 190.0F && z_m < 400.0F; ++i)
            if (std::abs(xs_m[i]) < 150.0F) knoll_m.push_back(row_m[i]);
    }
    const float share = std::clamp(parameters_.land_sea_level, 0.0F, 0.9F);
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<float>(all_m.size() - 1));
    std::nth_element(all_m.begin(), all_m.begin() + rank, all_m.end());
    std::nth_element(knoll_m.begin(), knoll_m.begin() + knoll_m.size() / 4, knoll_m.end());
    return std::min(all_m[rank] - 1.0F, knoll_m[knoll_m.size() / 4] - 1.5F);
}

// What closes the picture: rising beyond the land to where it is highest, then falling away.
void Terrain::add_ranges(std::span<const float> xs_m, float z_m, std::span<float> out) const {
    const scene::LandParameters& p = parameters_;
    // As high as may be, but no wall: the range closes the view and leaves the sky its share.
    const float height_m =
        std::min(p.range_height_m + p.range_relief * p.land_relief_m, kHighestRange * p.range_distance_m);
    const noise::Octaves octaves{
        .count = 5, .gain = p.range_gain, .ridged = std::min(p.range_ridged + 0.5F * rugged_, 1.0F)};
    const float farthest_m = std::max(std::abs(xs_m.front()), std::abs(xs_m.back()));
    if (farthest_m * farthest_m + z_m * z_m < 700.0F * 700.0F) return;
    std::vector<float> us(xs_m.begin(), xs_m.end());
    for (float& u : us) u /= p.range_wave_m;
    const std::vector<float> vs(xs_m.size(), z_m / p.range_wave_m);
    std::vector<float> ridges(xs_m.size());
    noise::fbm(range_, us, vs, ridges, octaves);
    for (std::size_t i = 0; i < xs_m.size(); ++i) {
        const float x_m = xs_m[i];
        const float out_m = std::sqrt(x_m * x_m + z_m * z_m);
        const float rise = glm::smoothstep(700.0F, p.range_distance_m, out_m);
        if (rise <= 0) continue;
        const float fall = 1.0F - 0.55F * glm::smoothstep(p.range_distance_m + 400.0F, 8000.0F, out_m);
        const float toward_north = 1.0F - 0.7F * p.range_north + p.range_north * (-z_m / out_m);
        out[i] += rise * fall * toward_north * height_m * std::max(0.0F, 0.42F + 1.15F * ridges[i]);
    }
    add_far_range(xs_m, z_m, height_m, out);
}

// Behind the range another, so much higher that it shows over the first one's saddles: a plane of its own in the air.
void Terrain::add_far_range(std::span<const float> xs_m, float z_m, float height_m, std::span<float> out) const {
    constexpr float kCrest_m = 6500.0F;
    constexpr float kBreadth_m = 1500.0F;
    const scene::LandParameters& p = parameters_;
    if (p.range_far <= 0 || z_m > 0) return;
    const float wave_m = 1.25F * p.range_wave_m;
    const float far_m = p.range_far * std::min(1.5F * height_m / p.range_distance_m, kHighestRange) * kCrest_m;
    std::vector<float> us(xs_m.begin(), xs_m.end());
    for (float& u : us) u = u / wave_m + 31.7F;
    const std::vector<float> vs(xs_m.size(), z_m / wave_m + 11.3F);
    std::vector<float> ridges(xs_m.size());
    noise::fbm(range_, us, vs, ridges, {.count = 5, .gain = 0.5F, .ridged = std::min(p.range_ridged + 0.4F, 1.0F)});
    for (std::size_t i = 0; i < xs_m.size(); ++i) {
        const float out_m = std::sqrt(xs_m[i] * xs_m[i] + z_m * z_m);
        const float off = std::abs(out_m - kCrest_m) / kBreadth_m;
        if (off >= 1) continue;
        const float toward_north = glm::smoothstep(0.0F, 0.45F, -z_m / out_m);
        out[i] += (1.0F - off * off) * toward_north * far_m * std::max(0.0F, 0.5F + 1.1F * ridges[i]);
    }
}

// Noise of about [-1, 1], mixed of the laws that the genes ask for.
void Terrain::add_hills(std::span<const float> xs_m, float z_m, float cell_m, std::span<float> out) const {
    const scene::LandParameters& p = parameters_;
    int count = 1;
    const float finest_m = std::max(2.5F * cell_m, p.hill_finest_m);
    for (float wave_m = p.land_feature_size_m; wave_m > finest_m && count < 9; wave_m /= p.hill_lacunarity) ++count;
    const float turn = glm::radians(p.hill_bearing_deg);
    const float cosine = std::cos(turn) / p.land_feature_size_m;
    const float sine = std::sin(turn) / p.land_feature_size_m;
    std::vector<float> us(xs_m.size());
    std::vector<float> vs(xs_m.size());
    for (std::size_t i = 0; i < xs_m.size(); ++i) {
        us[i] = xs_m[i] * cosine + z_m * sine;
        vs[i] = (z_m * cosine - xs_m[i] * sine) / p.hill_stretch;
    }
    if (p.hill_warp > 0) {
        std::vector<float> fold(xs_m.size());
        std::vector<float> at_u(us);
        std::vector<float> at_v(vs);
        for (std::size_t i = 0; i < us.size(); ++i) {
            at_u[i] /= p.hill_warp_wave;
            at_v[i] /= p.hill_warp_wave;
        }
        noise::fbm(folds_, at_u, at_v, fold, {.count = 3, .gain = 0.4F});
        for (std::size_t i = 0; i < us.size(); ++i) {
            us[i] += p.hill_warp * fold[i];
            vs[i] += 0.7F * p.hill_warp * fold[i];
        }
    }
    noise::Octaves octaves{.count = count,
                           .gain = p.land_gain,
                           .ridged = std::min(0.75F * rugged_ + p.hill_ridged, 1.0F),
                           .lacunarity = p.hill_lacunarity};
    noise::fbm(hills_, us, vs, out, octaves);
    octaves.ridged = 0;
    std::vector<float> other;
    const auto blend = [&](float share, noise::Basis basis, noise::Mix law, float scale) {
        if (share <= 0) return;
        other.resize(xs_m.size());
        octaves.basis = basis;
        octaves.mix = law;
        noise::fbm(hills_, us, vs, other, octaves);
        for (std::size_t i = 0; i < out.size(); ++i) out[i] += share * (scale * other[i] - out[i]);
    };
    blend(p.hill_hybrid, noise::Basis::Gradient, noise::Mix::Hybrid, 0.9F);
    blend(p.hill_hetero, noise::Basis::Gradient, noise::Mix::Hetero, 0.8F);
    blend(p.hill_cells, noise::Basis::Cells, noise::Mix::Sum, 0.6F);
}

void Terrain::above_lowest_m(std::span<const float> xs_m, float z_m, float cell_m, std::span<float> out) const {
    const scene::LandParameters& p = parameters_;
    add_hills(xs_m, z_m, cell_m, out);
    // 0 in the hollow to 1 on the heights; u east, v south, 1 at the land's edge.
    const float v = z_m / kHalfSide_m;
    const float bend =
        valley_phase_ * (0.55F - v) + p.form_valley_bend * noise::gradient(bends_, 0.8F * v + 7.3F, 0.37F);
    const float north = p.form_north_rise * glm::smoothstep(-0.1F, -1.7F, v);
    const float flank_share = p.form_flank_rise * (0.55F + 0.45F * glm::smoothstep(0.9F, -0.6F, v));
    const float reach = p.form_knoll_size * p.form_knoll_size;
    const float dv = v - 0.66F;
    const float knoll_share = p.form_knoll_rise * std::exp(-dv * dv / reach);
    const float least = 1.0F - p.form_hollow_calm;
    for (std::size_t i = 0; i < xs_m.size(); ++i) {
        const float u = xs_m[i] / kHalfSide_m;
        const float aside = (u - bend) / p.form_valley_width;
        const float flank = 1.0F - 1.0F / (1.0F + aside * aside);
        const float beside = 1.0F + 0.256F * u * u / reach;  // about a bell's shape, cheaper
        const float form = 0.10F + flank_share * flank + north + knoll_share / (beside * beside);
        // Hills grow out of the heights; the hollow stays calm.
        const float swing = least + (1.0F - least) * std::min(form, 1.2F);
        out[i] = form_relief_m_ * form + 1.25F * noise_relief_m_ * swing * out[i];
    }
    landforms_.shape_ground(xs_m, z_m, out);
    lower_outskirts(xs_m, z_m, out);
    add_ranges(xs_m, z_m, out);
}

// Beyond the land's edge heights that would stand over the viewer like a wall are pressed down, softly.
void Terrain::lower_outskirts(std::span<const float> xs_m, float z_m, std::span<float> out) const {
    const float near_m = 0.42F * form_relief_m_ + 14.0F;  // about the height the viewer stands at
    for (std::size_t i = 0; i < xs_m.size(); ++i) {
        const float out_m = std::sqrt(xs_m[i] * xs_m[i] + z_m * z_m);
        const float share = glm::smoothstep(420.0F, 900.0F, out_m);
        const float least_m = near_m + 0.035F * out_m;
        if (share <= 0 || out[i] <= least_m) continue;
        const float over_m = out[i] - least_m;
        const float most_m = 0.075F * out_m;
        out[i] -= share * (over_m - over_m * most_m / (over_m + most_m));
    }
}

void Terrain::heights_m(std::span<const float> xs_m, float z_m, float cell_m, std::span<float> out) const {
    above_lowest_m(xs_m, z_m, cell_m, out);
    for (float& h : out) h -= sea_m_;
    landforms_.shape_shore(xs_m, z_m, out);
}

}  // namespace quadrat::synthesis::land
