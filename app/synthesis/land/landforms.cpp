// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/landforms.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "scene/land_parameters.hpp"

namespace quadrat::synthesis::land {
namespace {

float mix(float a, float b, float t) { return a + t * (b - a); }

// 1 on the land, 0 before its border.
float inside(float x_m, float z_m) {
    return 1.0F - glm::smoothstep(390.0F, 500.0F, std::max(std::abs(x_m), std::abs(z_m)));
}

// 0 where the viewer stands.
float off_the_knoll(float x_m, float z_m) {
    const float dz = z_m - 300.0F;
    return 1.0F - std::exp(-(x_m * x_m + dz * dz) / (150.0F * 150.0F));
}

// Noise along a row of places, waves of this length.
std::vector<float> noise_row(noise::Key key, std::span<const float> xs_m, float z_m, float wave_m, glm::vec2 shift,
                             const noise::Octaves& octaves) {
    std::vector<float> us(xs_m.size());
    const std::vector<float> vs(xs_m.size(), z_m / wave_m + shift.y);
    std::vector<float> out(xs_m.size());
    for (std::size_t i = 0; i < us.size(); ++i) us[i] = xs_m[i] / wave_m + shift.x;
    noise::fbm(key, us, vs, out, octaves);
    return out;
}

}  // namespace

Landforms::Landforms(const scene::LandParameters& parameters, base::Seed seed)
    : p_(parameters), seed_(seed.child("landforms")), wander_(seed.child("wander")) {
    base::RandomStream random{seed_};
    side_ = random.unit() < 0.5 ? -1.0F : 1.0F;
}

void Landforms::shape_ground(Row xs_m, float z_m, Heights h) const {
    if (p_.island_share > 0) islands(xs_m, z_m, h);
    if (p_.mesa_share > 0) mesas(h);
    if (p_.terrace_share > 0) terraces(xs_m, z_m, h);
    if (p_.cone_share > 0) cone(xs_m, z_m, h);
    if (p_.karst_share > 0) karst(xs_m, z_m, h);
}

void Landforms::shape_shore(Row xs_m, float z_m, Heights h) const {
    if (p_.canyon_share > 0) canyon(xs_m, z_m, h);
    if (p_.cliff_share > 0) cliffs(h);
    if (p_.marsh_share > 0) marsh(xs_m, z_m, h);
}

void Landforms::islands(Row xs_m, float z_m, Heights h) const {
    const auto n = noise_row(wander_, xs_m, z_m, p_.island_wave_m, {0, 0}, {.count = 2, .gain = 0.4F});
    for (std::size_t i = 0; i < h.size(); ++i) {
        const float knoll = 1.0F - off_the_knoll(xs_m[i], z_m);
        h[i] += p_.island_share * std::min(p_.land_relief_m, 0.3F * p_.island_wave_m) * (1.5F * n[i] + 0.4F * knoll);
    }
}

// Heights are cut off flat, and what lies right under the edge falls steeply.
void Landforms::mesas(Heights h) const {
    const float level_m = p_.mesa_level * p_.land_relief_m;
    for (float& height : h) {
        if (height > level_m) {
            height = level_m + (height - level_m) * (1.0F - 0.93F * p_.mesa_share);
        } else if (height > 0.7F * level_m) {
            const float t = (height - 0.7F * level_m) / (0.3F * level_m);
            height = level_m * (0.7F + 0.3F * mix(t, glm::smoothstep(0.3F, 0.7F, t), p_.mesa_share));
        }
    }
}

void Landforms::terraces(Row xs_m, float z_m, Heights h) const {
    const auto bends = noise_row(wander_, xs_m, z_m, 160.0F, {31.0F, 0}, {.count = 1});
    for (std::size_t i = 0; i < h.size(); ++i) {
        const float bend = 0.5F * bends[i];
        const float steps = h[i] / p_.terrace_step_m + bend;
        const float on = std::floor(steps);
        const float half_edge = 0.5F * p_.terrace_edge;
        const float stepped = on + glm::smoothstep(0.5F - half_edge, 0.5F + half_edge, steps - on) - bend;
        h[i] = mix(h[i], stepped * p_.terrace_step_m, 0.92F * p_.terrace_share);
    }
}

void Landforms::cone(Row xs_m, float z_m, Heights h) const {
    const float top_m = (0.35F + 0.65F * p_.cone_share) * (45.0F + 0.9F * p_.land_relief_m);
    const float x0_m = 512.0F * p_.cone_east;
    const float rim = std::pow(1.0F - p_.cone_crater, 1.8F);
    for (std::size_t i = 0; i < h.size(); ++i) {
        const float r = std::hypot(xs_m[i] - x0_m, z_m + 130.0F) / p_.cone_radius_m;
        if (r >= 1) continue;
        const float in_crater = r / p_.cone_crater;
        const float shape = in_crater < 1 ? rim - 0.4F * p_.cone_crater * 2.2F * (1.0F - in_crater * in_crater)
                                          : std::pow(1.0F - r, 1.8F);
        h[i] += top_m * shape * inside(xs_m[i], z_m);
    }
}

void Landforms::karst(Row xs_m, float z_m, Heights h) const {
    const float spacing_m = p_.karst_spacing_m;
    const base::Seed towers = seed_.child("towers");
    const auto roughness = noise_row(wander_, xs_m, z_m, 34.0F, {0, 0}, {.count = 3});
    for (std::size_t i = 0; i < h.size(); ++i) {
        const float where = inside(xs_m[i], z_m) * off_the_knoll(xs_m[i], z_m);
        if (where <= 0.01F) continue;
        const float u = xs_m[i] / spacing_m;
        const float v = z_m / spacing_m;
        const int cu = static_cast<int>(std::floor(u));
        const int cv = static_cast<int>(std::floor(v));
        const float rough = 1.0F + 0.55F * roughness[i];
        float most = 0;
        for (int dv = -1; dv <= 1; ++dv) {
            for (int du = -1; du <= 1; ++du) {
                const std::uint64_t hash = base::hash_of(towers, cu + du, cv + dv);
                if (base::unit_of(hash << 8U) > 0.25F + 0.6F * p_.karst_share) continue;
                const float x = u - (static_cast<float>(cu + du) + 0.2F + 0.6F * base::unit_of(hash));
                const float y = v - (static_cast<float>(cv + dv) + 0.2F + 0.6F * base::unit_of(hash << 16U));
                const float radius = 0.17F + 0.17F * base::unit_of(hash << 24U);
                const float r = rough * std::sqrt(x * x + y * y) / radius;
                const float tall = 0.4F + 0.6F * base::unit_of(hash << 32U);
                most = std::max(most, tall * (1.0F - glm::smoothstep(0.45F, 1.0F, r)) * (1.0F - 0.2F * r * r));
            }
        }
        h[i] += most * p_.karst_height_m * where;
    }
}

void Landforms::canyon(Row xs_m, float z_m, Heights h) const {
    constexpr float kFloor_m = 1.6F;
    const float wind = noise::fbm(wander_, z_m / 330.0F, 5.5F, {.count = 3, .gain = 0.45F});
    const float middle_m = side_ * 150.0F + 260.0F * p_.canyon_bend * wind;
    for (std::size_t i = 0; i < h.size(); ++i) {
        if (h[i] <= kFloor_m) continue;
        const float away_m = std::abs(xs_m[i] - middle_m) - 0.5F * p_.canyon_width_m;
        const float wall_m = 10.0F + 0.55F * h[i];
        const float cut =
            (1.0F - glm::smoothstep(0.0F, wall_m, away_m)) * inside(xs_m[i], z_m) * off_the_knoll(xs_m[i], z_m);
        h[i] -= 0.95F * p_.canyon_share * cut * (h[i] - kFloor_m);
    }
}

void Landforms::heap_dunes(Row xs_m, float z_m, Heights h) const {
    if (p_.dune_share <= 0) return;
    const float bearing = glm::radians(p_.dune_bearing_deg);
    const float along_x = std::sin(bearing) / p_.dune_wave_m;
    const float along_z = -std::cos(bearing) / p_.dune_wave_m;
    // The lee side keeps sand's angle of repose.
    const float tall_m = p_.dune_share * std::min(p_.dune_height_m, 0.44F * p_.dune_lee * p_.dune_wave_m);
    const float windward = 1.0F - p_.dune_lee;
    const auto bends = noise_row(wander_, xs_m, z_m, p_.dune_wave_m / 0.6F, {0, 0}, {.count = 2});
    const auto patches = noise_row(wander_, xs_m, z_m, 140.0F, {0, 77.0F}, {.count = 1});
    for (std::size_t i = 0; i < h.size(); ++i) {
        const float low = glm::smoothstep(0.4F, 2.5F, h[i]) *
                          (1.0F - glm::smoothstep(0.35F, 0.75F, h[i] / std::max(p_.land_relief_m, 80.0F)));
        const float where = low * inside(xs_m[i], z_m);
        if (where <= 0) continue;
        const float phase = xs_m[i] * along_x + z_m * along_z + 0.65F * bends[i];
        const float t = phase - std::floor(phase);
        // A long back, a sharp crest, a slip face with a soft foot.
        const float up = t / windward;
        const float down = (1.0F - t) / p_.dune_lee;
        const float rise = t < windward ? up * up * (1.5F - 0.5F * up) : down * std::sqrt(down);
        const float patch = 0.6F + 0.9F * patches[i];
        h[i] += tall_m * where * std::max(patch, 0.15F) * rise;
    }
}

void Landforms::cliffs(Heights h) const {
    const float tall_m = p_.cliff_share * p_.cliff_height_m;
    for (float& height : h)
        if (height > 0)
            height += tall_m * glm::smoothstep(0.1F, 1.4F, height) *
                      (1.0F - glm::smoothstep(1.2F * tall_m, 6.0F * tall_m, height));
}

void Landforms::marsh(Row xs_m, float z_m, Heights h) const {
    const auto ground = noise_row(wander_, xs_m, z_m, 17.0F, {0, 0}, {.count = 2});
    for (std::size_t i = 0; i < h.size(); ++i) {
        const float depth = std::abs(h[i]) / p_.marsh_height_m;
        if (depth >= 1) continue;
        const float flat = mix(1.0F, 0.18F + 0.82F * depth * depth, p_.marsh_share);
        const float hummocks = ground[i] * inside(xs_m[i], z_m);
        h[i] = h[i] * flat + 1.1F * p_.marsh_share * (1.0F - depth) * hummocks;
    }
}

}  // namespace quadrat::synthesis::land
