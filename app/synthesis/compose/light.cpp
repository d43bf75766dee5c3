// SPDX-License-Identifier: Apache-2.0
#include "synthesis/compose/light.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <vector>

#include "synthesis/compose/crown_shadows.hpp"
#include "synthesis/compose/stone_shadows.hpp"

namespace quadrat::synthesis {
namespace {

constexpr float kNoShadow_m = -1.0e5F;
constexpr float kSoftness = 0.022F;  // of a shadow's edge, to its distance: wider than the sun's, as air makes it
constexpr float kDeepest_m = 24.0F;

template <typename Row>
void for_rows(int rows, const Row& row) {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, rows, 16), [&](const auto& range) {
        for (int y = range.begin(); y != range.end(); ++y) row(y);
    });
}

// The share of the sky seen past the land, from the horizon in eight directions; a quarter of the land's samples.
mesh::Field sky_openness(const scene::Land& land) {
    const int side = (land.height_m.columns - 1) / 2;
    mesh::Field open(side, side);
    constexpr std::array<float, 4> kSteps{2.5F, 7.0F, 17.0F, 40.0F};
    constexpr std::array<std::array<float, 2>, 8> kWays{{{1, 0},
                                                         {0.70711F, 0.70711F},
                                                         {0, 1},
                                                         {-0.70711F, 0.70711F},
                                                         {-1, 0},
                                                         {-0.70711F, -0.70711F},
                                                         {0, -1},
                                                         {0.70711F, -0.70711F}}};
    for_rows(side, [&](int y) {
        for (int x = 0; x < side; ++x) {
            const float column = 2.0F * static_cast<float>(x) + 1.0F;
            const float row = 2.0F * static_cast<float>(y) + 1.0F;
            const float here = mesh::sample(land.height_m, column, row);
            float hidden = 0;
            for (const auto& way : kWays) {
                float steepest = 0;
                for (const float step : kSteps) {
                    const int c =
                        std::clamp(static_cast<int>(column + step * way[0] + 0.5F), 0, land.height_m.columns - 1);
                    const int r = std::clamp(static_cast<int>(row + step * way[1] + 0.5F), 0, land.height_m.rows - 1);
                    steepest = std::max(steepest, (land.height_m.at(c, r) - here) / (step * land.cell_m));
                }
                hidden += steepest * steepest / (1.0F + steepest * steepest);  // sine squared of the horizon's height
            }
            open.at(x, y) = 1.0F - hidden / static_cast<float>(kWays.size());
        }
    });
    return open;
}

// Takes away this share of the light where something hides all of it.
void darken(mesh::Field& light, const mesh::Field& hidden, float share) {
    for (std::size_t i = 0; i < hidden.samples.size(); ++i) light.samples[i] *= 1.0F - share * hidden.samples[i];
}

std::uint8_t half_byte(float linear) {
    return static_cast<std::uint8_t>(std::clamp(127.5F * linear + 0.5F, 0.0F, 255.0F));
}

}  // namespace

// A sweep away from the sun, a row (or column) after the other: what shades a sample is what shaded its neighbour
// toward the sun, lower by the ray's fall, or that neighbour itself.
LandShadow::LandShadow(const scene::Land& land, const glm::vec3& sun)
    : top_m_(land.height_m.columns, land.height_m.rows, kNoShadow_m),
      away_m_(land.height_m.columns, land.height_m.rows, 0.0F),
      cell_m_(land.cell_m) {
    const bool by_rows = std::abs(sun.z) >= std::abs(sun.x);
    const float main = by_rows ? sun.z : sun.x;
    const float side = by_rows ? sun.x : sun.z;
    if (std::abs(main) < 1.0e-4F) return;  // the sun stands overhead
    const int n = land.height_m.columns;
    const float shift = side / std::abs(main);
    const float step_m = land.cell_m * std::sqrt(1.0F + shift * shift);
    const float fall_m = land.cell_m * sun.y / std::abs(main);
    const int first = main > 0 ? n - 1 : 0;
    const int stride = main > 0 ? -1 : 1;
    const auto at = [by_rows](auto& field, int along, int across) -> auto& {
        return by_rows ? field.at(across, along) : field.at(along, across);
    };
    for (int k = 1; k < n; ++k) {
        const int line = first + k * stride;
        const int before = line - stride;
        for (int i = 0; i < n; ++i) {
            const float from = std::clamp(static_cast<float>(i) + shift, 0.0F, static_cast<float>(n - 1));
            const int i0 = std::min(static_cast<int>(from), n - 2);
            const float t = from - static_cast<float>(i0);
            const auto between = [&](auto& field) {
                return at(field, before, i0) + t * (at(field, before, i0 + 1) - at(field, before, i0));
            };
            const float ground_m = between(land.height_m);
            const float shade_m = between(top_m_);
            const bool is_nearer = ground_m >= shade_m;
            at(top_m_, line, i) = (is_nearer ? ground_m : shade_m) - fall_m;
            at(away_m_, line, i) = (is_nearer ? 0.0F : between(away_m_)) + step_m;
        }
    }
}

float LandShadow::sun_at(const glm::vec3& p) const {
    const float half = 0.5F * static_cast<float>(top_m_.columns - 1);
    const float column = p.x / cell_m_ + half;
    const float row = p.z / cell_m_ + half;
    const float edge_m = 0.35F + kSoftness * mesh::sample(away_m_, column, row);
    const float t = std::clamp(0.5F + (p.y - mesh::sample(top_m_, column, row)) / (2.0F * edge_m), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

scene::BakedLight bake_light(const scene::Land& land, const scene::Sky& sky, const scene::Flora& flora,
                             std::span<const scene::Plant> plants, const LandShadow& shadow, int side_px) {
    scene::BakedLight light{mesh::Image(side_px, side_px, 4)};
    const mesh::Field open = sky_openness(land);
    CrownShade crowns = cast_crowns(land, sky.sun_direction, flora, plants, side_px);
    darken(crowns.sun, cast_stone(land, sky.sun_direction, side_px), 0.94F);
    darken(crowns.sky, cast_stone(land, {0, 1, 0}, side_px), 0.6F);
    const float px_m = land.side_m() / static_cast<float>(side_px);
    const float half_m = 0.5F * land.side_m();
    const float open_per_px = static_cast<float>(open.columns) / static_cast<float>(side_px);
    for_rows(side_px, [&](int y) {
        for (int x = 0; x < side_px; ++x) {
            const glm::vec2 at{(static_cast<float>(x) + 0.5F) * px_m - half_m,
                               (static_cast<float>(y) + 0.5F) * px_m - half_m};
            const float height_m = scene::ground_height_m(land, at);
            // Under water it is the surface that takes the light.
            const glm::vec3 normal = height_m > 0 ? scene::ground_normal(land, at) : glm::vec3{0, 1, 0};
            const float facing = std::max(glm::dot(normal, sky.sun_direction), 0.0F);
            const float sun =
                facing * crowns.sun.at(x, y) * shadow.sun_at({at.x, std::max(height_m, 0.0F) + 0.1F, at.y});
            const float seen = mesh::sample(open, (static_cast<float>(x) + 0.5F) * open_per_px - 0.5F,
                                            (static_cast<float>(y) + 0.5F) * open_per_px - 0.5F) *
                               crowns.sky.at(x, y);
            const glm::vec3 ambient = seen * (normal.y * sky.light_above + (1.0F - normal.y) * sky.light_around) +
                                      (1.0F - seen) * 0.6F * sky.light_below;
            const glm::vec3 c = sun * sky.sunlight + ambient;
            std::uint8_t* pixel = light.ground.pixel(x, y);
            pixel[0] = half_byte(c.x);
            pixel[1] = half_byte(c.y);
            pixel[2] = half_byte(c.z);
            pixel[3] =
                static_cast<std::uint8_t>(255.0F * std::clamp(scene::water_depth_m(land, at) / kDeepest_m, 0.0F, 1.0F));
        }
    });
    return light;
}

void light_plants(std::span<scene::Plant> plants, const scene::Flora& flora, const scene::Sky& sky,
                  const LandShadow& shadow) {
    constexpr float kBin_m = 12.0F;
    const auto bin_of = [](float x, float z) {
        return (static_cast<std::int64_t>(std::floor(x / kBin_m)) << 32) ^
               (static_cast<std::int64_t>(std::floor(z / kBin_m)) & 0xFFFFFFFF);
    };
    std::unordered_map<std::int64_t, std::vector<std::size_t>> bins;
    for (std::size_t i = 0; i < plants.size(); ++i)
        if (flora.species[plants[i].species].storey == scene::Storey::Tree)
            bins[bin_of(plants[i].root_m.x, plants[i].root_m.z)].push_back(i);

    // What a ray toward the sun from this point passes through of the crowns around.
    const auto past_neighbours = [&](std::size_t self, const glm::vec3& from) {
        float through = 1;
        for (int dz = -1; dz <= 1; ++dz) {
            for (int dx = -1; dx <= 1; ++dx) {
                const auto found = bins.find(
                    bin_of(from.x + static_cast<float>(dx) * kBin_m, from.z + static_cast<float>(dz) * kBin_m));
                if (found == bins.end()) continue;
                for (const std::size_t i : found->second) {
                    if (i == self) continue;
                    const scene::Species& species = flora.species[plants[i].species];
                    const float high_m = species.height_m * plants[i].scale;
                    const glm::vec3 crown = plants[i].root_m + glm::vec3{0, 0.6F * high_m, 0};
                    const float along = glm::dot(crown - from, sky.sun_direction);
                    if (along <= 0) continue;
                    const glm::vec3 miss = (crown - from - along * sky.sun_direction) /
                                           glm::vec3{species.crown_radius_m * plants[i].scale, 0.42F * high_m,
                                                     species.crown_radius_m * plants[i].scale};
                    const float r = glm::dot(miss, miss);
                    if (r < 1) through *= 1.0F - 0.62F * (1.0F - r);
                }
            }
        }
        return through;
    };
    oneapi::tbb::parallel_for(std::size_t{0}, plants.size(), [&](std::size_t i) {
        scene::Plant& plant = plants[i];
        const scene::Species& species = flora.species[plant.species];
        const float up = species.storey == scene::Storey::Tree ? 0.6F : 0.9F;
        const glm::vec3 from = plant.root_m + glm::vec3{0, up * species.height_m * plant.scale, 0};
        plant.sun = shadow.sun_at(from) * past_neighbours(i, from);
    });
}

}  // namespace quadrat::synthesis
