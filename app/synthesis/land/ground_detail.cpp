// SPDX-License-Identifier: Apache-2.0
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "synthesis/land/ground.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {
namespace {

std::uint8_t byte_of(float value) { return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F)); }

// Relief of one tile, about -1 to 1, mean near 0.
using Tile = mesh::Field;

void noise_row(noise::Key key, int side, int y, int period, const noise::Octaves& octaves, std::span<float> out) {
    std::vector<float> us(out.size());
    const float per_px = static_cast<float>(period) / static_cast<float>(side);
    for (std::size_t x = 0; x < us.size(); ++x) us[x] = static_cast<float>(x) * per_px;
    const std::vector<float> vs(out.size(), static_cast<float>(y) * per_px);
    noise::fbm_tiled(key, us, vs, out, period, octaves);
}

// Tufts, and blades between them.
Tile soft_tile(base::Seed seed, int side) {
    Tile tile(side, side);
    const noise::Key tufts(seed.child("tufts"));
    const noise::Key blades(seed.child("detail"));
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, side, 32), [&](const auto& rows) {
        std::vector<float> fine(static_cast<std::size_t>(side));
        for (int y = rows.begin(); y != rows.end(); ++y) {
            const auto out = std::span(tile.samples).subspan(tile.index(0, y), fine.size());
            noise_row(tufts, side, y, 6, {.count = 3, .gain = 0.6F}, out);
            noise_row(blades, side, y, 24, {.count = 2, .gain = 0.7F}, fine);
            for (std::size_t x = 0; x < fine.size(); ++x) out[x] = 1.1F * out[x] + 0.77F * fine[x];
        }
    });
    return tile;
}

// Facets and clefts: noise folded to sharp valleys, and chips.
Tile stone_tile(base::Seed seed, int side) {
    Tile tile(side, side);
    const noise::Key clefts(seed.child("clefts"));
    const noise::Key chips(seed.child("chips"));
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, side, 32), [&](const auto& rows) {
        std::vector<float> fine(static_cast<std::size_t>(side));
        for (int y = rows.begin(); y != rows.end(); ++y) {
            const auto out = std::span(tile.samples).subspan(tile.index(0, y), fine.size());
            noise_row(clefts, side, y, 5, {.count = 4, .gain = 0.55F, .ridged = 1}, out);
            noise_row(chips, side, y, 20, {.count = 2, .gain = 0.6F}, fine);
            for (std::size_t x = 0; x < fine.size(); ++x) out[x] = 0.75F - 1.5F * out[x] + 0.5F * fine[x];
        }
    });
    double mean = 0;
    for (const float h : tile.samples) mean += h;
    for (float& h : tile.samples) h -= static_cast<float>(mean / static_cast<double>(tile.samples.size()));
    return tile;
}

}  // namespace

GroundDetail ground_detail(base::Seed seed, int side_px, float contrast, float bumps) {
    GroundDetail detail{mesh::Image(side_px, side_px, 2), mesh::Image(side_px, side_px, 4)};
    const Tile tiles[2] = {soft_tile(seed, side_px), stone_tile(seed, side_px)};
    // Of a relief of a thirtieth of the tile, per pixel.
    const float slope_of = bumps * static_cast<float>(side_px) / 30.0F;
    const auto wrapped = [side_px](int i) { return (i + side_px) % side_px; };
    for (std::size_t kind = 0; kind < 2; ++kind) {
        const Tile& tile = tiles[kind];
        oneapi::tbb::parallel_for(0, side_px, [&](int y) {
            for (int x = 0; x < side_px; ++x) {
                const float east = 0.5F * slope_of * (tile.at(wrapped(x + 1), y) - tile.at(wrapped(x - 1), y));
                const float south = 0.5F * slope_of * (tile.at(x, wrapped(y + 1)) - tile.at(x, wrapped(y - 1)));
                detail.grain.pixel(x, y)[kind] = byte_of(128.0F + 62.0F * contrast * tile.at(x, y));
                detail.slopes.pixel(x, y)[2 * kind] = byte_of(128.0F + 127.0F * east);
                detail.slopes.pixel(x, y)[2 * kind + 1] = byte_of(128.0F + 127.0F * south);
            }
        });
    }
    return detail;
}

}  // namespace quadrat::synthesis::land
