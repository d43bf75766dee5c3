// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/country.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <span>
#include <vector>

#include "scene/colour.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/land/erosion.hpp"
#include "synthesis/land/ground.hpp"
#include "synthesis/land/patterns.hpp"
#include "synthesis/land/rivers.hpp"
#include "synthesis/land/roads.hpp"
#include "synthesis/land/stone.hpp"
#include "synthesis/land/terrain.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr float kSide_m = 1024.0F;
constexpr float kSurroundCell_m = 64.0F;
constexpr int kSurroundSamples = 257;
constexpr float kSeam_m = 72.0F;   // over which the land comes to meet the surround
constexpr float kBelow_m = 40.0F;  // of the surround under the land

// work(xs_m, z_m, heights of the row), rows in parallel.
template <typename Work>
void for_rows(mesh::Field& field, float cell_m, const Work& work) {
    const float half = 0.5F * static_cast<float>(field.columns - 1);
    std::vector<float> xs_m(static_cast<std::size_t>(field.columns));
    for (int i = 0; i < field.columns; ++i) xs_m[i] = (static_cast<float>(i) - half) * cell_m;
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, field.rows, 8), [&](const auto& rows) {
        for (int row = rows.begin(); row != rows.end(); ++row)
            work(std::span<const float>(xs_m), xs_m[row],
                 std::span(field.samples).subspan(field.index(0, row), xs_m.size()));
    });
}

mesh::Field field_of(const Terrain& terrain, int samples, float cell_m) {
    mesh::Field field(samples, samples);
    for_rows(field, cell_m, [&](std::span<const float> xs_m, float z_m, std::span<float> heights_m) {
        terrain.heights_m(xs_m, z_m, cell_m, heights_m);
    });
    return field;
}

float sample_m(const mesh::Field& surround_m, float x_m, float z_m) {
    const float half = 0.5F * static_cast<float>(surround_m.columns - 1);
    return mesh::sample(surround_m, x_m / kSurroundCell_m + half, z_m / kSurroundCell_m + half);
}

// The land's edge lies exactly on the surround's facets, so there is no gap between them.
void meet_surround(mesh::Field& height_m, float cell_m, const mesh::Field& surround_m) {
    const float half_m = 0.5F * kSide_m;
    const float half = 0.5F * static_cast<float>(height_m.columns - 1);
    for (int row = 0; row < height_m.rows; ++row) {
        for (int column = 0; column < height_m.columns; ++column) {
            const float x_m = (static_cast<float>(column) - half) * cell_m;
            const float z_m = (static_cast<float>(row) - half) * cell_m;
            const float inside_m = half_m - std::max(std::abs(x_m), std::abs(z_m));
            if (inside_m >= kSeam_m) continue;
            const float t = inside_m / kSeam_m;
            const float share = t * t * (3.0F - 2.0F * t);
            const float outer = sample_m(surround_m, x_m, z_m);
            float& h = height_m.at(column, row);
            h = outer + share * (h - outer);
        }
    }
}

void sink_under_land(mesh::Field& surround_m) {
    const float half = 0.5F * static_cast<float>(surround_m.columns - 1);
    const float inside = 0.5F * kSide_m / kSurroundCell_m - 0.5F;
    for (int row = 0; row < surround_m.rows; ++row)
        for (int column = 0; column < surround_m.columns; ++column)
            if (std::max(std::abs(static_cast<float>(column) - half), std::abs(static_cast<float>(row) - half)) <
                inside)
                surround_m.at(column, row) -= kBelow_m;
}

// The country around has been worn as the land has; next to it, it stays as it was.
void carve_surround(mesh::Field& surround_m, const scene::LandParameters& p) {
    mesh::Field worn = surround_m;
    carve_valleys(worn, kSurroundCell_m,
                  {.steps = 8, .strength = 0.5F + 0.6F * p.erosion_strength, .spring_m2 = 12000, .hillslope = 0.03F});
    const float half = 0.5F * static_cast<float>(surround_m.columns - 1);
    for (int row = 0; row < surround_m.rows; ++row) {
        for (int column = 0; column < surround_m.columns; ++column) {
            const float out_m =
                kSurroundCell_m * std::hypot(static_cast<float>(column) - half, static_cast<float>(row) - half);
            const float t = std::clamp((out_m - 800.0F) / 700.0F, 0.0F, 1.0F);
            float& h = surround_m.at(column, row);
            h += t * t * (3.0F - 2.0F * t) * (worn.at(column, row) - h);
        }
    }
}

void set_distant_colours(scene::Land& land, const Palette& palette, const scene::LandParameters& p) {
    land.snow_line_m = snow_line_m(p);
    land.shallow_colour = palette.shallow;
    land.deep_colour = palette.deep;
    land.far_colour = scene::mix_colours(scene::mix_colours(palette.lush, palette.dry, 0.4F), palette.scree,
                                         p.land_gain > 0.45F ? 0.5F : 0.2F);
}

// Nothing is planted on this ground.
void keep_clear(scene::Land& land, const Footprint& court) {
    auto& kept = land.kept_clear;
    if (kept.samples.empty()) kept = {land.height_m.columns, land.height_m.rows, 255};
    mesh::Field to_edge_m(1, 1);
    const float half = 0.5F * static_cast<float>(kept.columns - 1);
    const float reach = (court.radius_m + scene::kFarFromRoads_m) / land.cell_m;
    const glm::vec2 middle = court.at_m / land.cell_m + half;
    for (int row = static_cast<int>(middle.y - reach); row <= static_cast<int>(middle.y + reach); ++row) {
        for (int column = static_cast<int>(middle.x - reach); column <= static_cast<int>(middle.x + reach); ++column) {
            if (!kept.is_inside(column, row)) continue;
            const glm::vec2 off = glm::vec2{static_cast<float>(column), static_cast<float>(row)} - middle;
            to_edge_m.at(0, 0) = land.cell_m * glm::length(off) - court.radius_m;
            kept.at(column, row) = std::min(kept.at(column, row), scene::kept_clear_of(to_edge_m).at(0, 0));
        }
    }
}

void lay_stones(scene::Land& land, Stones stones, mesh::Image& albedo) {
    shade_under(albedo, kSide_m, stones.footprints);
    land.stone = std::move(stones.stone);
    land.landmarks = std::move(stones.landmarks);
    for (const Footprint& court : stones.forecourts) keep_clear(land, court);
}

// Streams, slides and wind at work on the heights.
void wear(scene::Land& land, const Terrain& terrain, const scene::LandParameters& p) {
    carve_valleys(land.height_m, land.cell_m,
                  {.steps = static_cast<int>(std::lround(p.erosion_age)),
                   .strength = p.erosion_strength,
                   .deposit = p.erosion_sediment,
                   .fans = p.erosion_fans,
                   .spring_m2 = p.erosion_spring_m2,
                   .hillslope = p.erosion_creep});
    slide_to_repose(land.height_m, land.cell_m, std::tan(glm::radians(p.erosion_repose_deg)),
                    static_cast<int>(std::lround(p.erosion_slides)));
    for_rows(land.height_m, land.cell_m, [&](std::span<const float> xs_m, float z_m, std::span<float> heights_m) {
        terrain.heap_dunes(xs_m, z_m, heights_m);
    });
}

void set_grain(scene::Land& land, const scene::LandParameters& p, base::Seed seed) {
    // With less than this the ground near by is airbrushed.
    constexpr float kLeastContrast = 0.85F;
    const float contrast = kLeastContrast + 0.65F * (p.ground_detail - 0.3F);
    GroundDetail detail = ground_detail(
        seed, 256, {.contrast = contrast, .bumps = p.ground_bumps, .sandy = sandy(p), .cracked = cracked(p)});
    land.detail = std::move(detail.grain);
    land.detail_slopes = std::move(detail.slopes);
    land.detail_tile_m = p.ground_detail_m;
}

}  // namespace

scene::Land make_land(const scene::LandParameters& p, base::Seed seed, const scene::Fineness& fineness,
                      Settlers* settlers) {
    scene::Land land;
    const Terrain terrain(p, seed);
    const Palette palette = choose_palette(p, seed);
    land.cell_m = kSide_m / static_cast<float>(fineness.land_samples - 1);
    land.surround_cell_m = kSurroundCell_m;
    land.height_m = field_of(terrain, fineness.land_samples, land.cell_m);
    wear(land, terrain, p);
    land.surround_m = field_of(terrain, kSurroundSamples, kSurroundCell_m);
    carve_surround(land.surround_m, p);
    land.surround_albedo = surround_colours(land.surround_m, kSurroundCell_m, palette, p, seed);
    meet_surround(land.height_m, land.cell_m, land.surround_m);
    sink_under_land(land.surround_m);
    FreshWater water = make_fresh_water(land.height_m, land.cell_m,
                                        {.river_area_m2 = p.river_area_m2,
                                         .lake_depth_m = p.lake_depth_m,
                                         .lake_area_m2 = p.lake_area_m2,
                                         .width = p.river_width,
                                         .depth = p.river_depth,
                                         .fall_m = p.fall_height_m,
                                         .hollows = p.dune_share > 0 ? Hollows::Seep : Hollows::Settle});
    if (p.site_share > 0) land.site = make_site(land.height_m, water.surface_m, land.cell_m, p.site_radius_m);
    if (p.road_share > 0 || land.site)
        land.roads = make_roads(land.height_m, water.surface_m, land.cell_m, land.site,
                                {.width_m = p.road_width_m, .grade = p.road_grade, .goes_on = p.road_share > 0}, seed);
    land.water_m = std::move(water.surface_m);
    set_distant_colours(land, palette, p);
    const std::vector<scene::Road> roads = land.roads;  // lanes are the settlers'
    if (settlers) settlers->build(land);
    const bool is_settled = !land.settlement.is_empty();
    mesh::Field to_edge_m =
        distance_to_roads_m(fineness.land_samples, land.cell_m, roads, is_settled ? std::nullopt : land.site);
    if (is_settled) settlers->keep_clear(land, to_edge_m);
    land.kept_clear = scene::kept_clear_of(to_edge_m);
    water.surface_m = std::move(land.water_m);
    const mesh::Field over_water_m = height_over_water_m(land.height_m, water);
    land.water_m = std::move(water.surface_m);
    land.fresh_water = std::move(water.mesh);

    const mesh::Field moisture = moisture_of(land.height_m, water.drained_area_m2, land.cell_m);
    const mesh::Field to_road_m = distance_to_roads_m(fineness.land_samples, land.cell_m, roads, std::nullopt);
    Ground ground = lay_ground({land.height_m, over_water_m, moisture, to_road_m, land.cell_m}, palette, p, seed,
                               fineness.albedo_px);
    land.kinds = std::move(ground.kinds);
    lay_stones(land, make_stones({land, over_water_m, palette}, p, seed.child("stones")), ground.albedo);
    if (is_settled) {
        settlers->paint(land, ground.albedo);
        land.landmarks.insert(land.landmarks.begin(), settlers->landmark());
    }
    ease_into_land(land.surround_albedo, kSurroundCell_m, ground.albedo, kSide_m);
    land.albedo = scene::GroundColours(ground.albedo);
    set_grain(land, p, seed);
    land.lichen = lichen_picture(seed.child("lichen"), p.ground_lichen);
    land.ripple = p.water_ripple;
    return land;
}

}  // namespace quadrat::synthesis::land
