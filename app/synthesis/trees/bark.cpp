// SPDX-License-Identifier: Apache-2.0
#include "synthesis/trees/bark.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <numeric>
#include <vector>

#include "synthesis/noise/gradient.hpp"
#include "synthesis/noise/reaction.hpp"

namespace quadrat::synthesis::trees {
namespace {

float tile_noise(noise::Key key, float u, float v, int period, int octaves) {
    const auto p = static_cast<float>(period);
    return noise::fbm_tiled(key, std::min(u * p, p * 0.999999F), std::min(v * p, p * 0.999999F), period,
                            {.count = octaves});
}

// The two nearest of the points of a torus with so many cells a side: Worley's noise of 1996.
glm::vec2 cells(base::Seed seed, float u, float v, int across, int along) {
    const float x = u * static_cast<float>(across);
    const float y = v * static_cast<float>(along);
    const int cx = static_cast<int>(std::floor(x));
    const int cy = static_cast<int>(std::floor(y));
    float first = 9;
    float second = 9;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int wx = (cx + dx + across) % across;
            const int wy = (cy + dy + along) % along;
            const std::uint64_t hash = base::hash_of(seed, wx, wy);
            const float px = static_cast<float>(cx + dx) + 0.1F + 0.8F * base::unit_of(hash);
            const float py = static_cast<float>(cy + dy) + 0.1F + 0.8F * base::unit_of(hash << 24U);
            const float d = std::hypot(x - px, y - py);
            second = std::min(second, std::max(first, d));
            first = std::min(first, d);
        }
    }
    return {first, second};
}

void normalise(mesh::Field& field) {
    const auto [low, high] = std::minmax_element(field.samples.begin(), field.samples.end());
    const float least = *low;
    const float range = std::max(*high - least, 1.0e-4F);
    for (float& value : field.samples) value = (value - least) / range;
}

// Ribs up the stem, of which the edges bear tufts of spines.
float ribs(float u, float v) {
    constexpr float kRibs = 6;  // a tile
    constexpr float kTufts = 7;
    const float rib = std::abs(std::sin(3.14159265F * kRibs * u));
    const float along = kTufts * v + 0.5F * static_cast<float>(static_cast<int>(kRibs * u) % 2);
    const float to_tuft = std::abs(along - std::round(along)) / 0.22F;
    const bool is_tuft = rib > 0.93F && to_tuft < 1;
    return 0.75F * std::sqrt(rib) + (is_tuft ? 0.25F : 0.0F);
}

// Of the reaction's second substance: where there is much of it the bark is level.
float plate(float concentration) {
    const float t = std::clamp((concentration - 0.06F) / 0.16F, 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

}  // namespace

mesh::Field bark_relief(Bark kind, base::Seed seed, int side) {
    mesh::Field relief(side, side);
    const noise::Key rough(seed.child("rough"));
    const noise::Key bend(seed.child("bend"));
    mesh::Field ridges;
    const int half = side / 2;
    if (kind == Bark::Furrowed) ridges = noise::react({}, seed.child("reaction"), half);
    const auto ridge_at = [&](float u, float v) {
        const float x = u * static_cast<float>(half);
        const float y = v * static_cast<float>(half);
        const int x0 = static_cast<int>(x) % half;
        const int y0 = static_cast<int>(y) % half;
        const float tx = x - std::floor(x);
        const float ty = y - std::floor(y);
        const auto at = [&](int dx, int dy) { return ridges.at((x0 + dx) % half, (y0 + dy) % half); };
        return (1 - ty) * ((1 - tx) * at(0, 0) + tx * at(1, 0)) + ty * ((1 - tx) * at(0, 1) + tx * at(1, 1));
    };
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const float u = (static_cast<float>(column) + 0.5F) / static_cast<float>(side);
            const float v = (static_cast<float>(row) + 0.5F) / static_cast<float>(side);
            const float grain = tile_noise(rough, u, v, 8, 3);
            float h = 0;
            switch (kind) {
                case Bark::Furrowed:
                    // Twice across for once along: plates longer than wide, level on top, with narrow clefts between.
                    h = 0.8F * plate(ridge_at(2 * u, v)) + 0.2F * grain;
                    break;
                case Bark::Plates: {
                    const float warp = 0.03F * tile_noise(bend, u, v, 4, 2);
                    const glm::vec2 f = cells(seed, std::fmod(u + warp + 1, 1.0F), std::fmod(v + warp + 1, 1.0F), 5, 3);
                    h = std::min(2.6F * (f.y - f.x), 1.0F) + 0.15F * grain;
                    break;
                }
                case Bark::Ribbed:
                    h = ribs(u, v) + 0.04F * grain;
                    break;
                case Bark::Smooth:
                    h = 0.5F + 0.22F * tile_noise(bend, u, v, 3, 2) + 0.05F * grain;
                    break;
                case Bark::Banded: {
                    // Short dark bands around the limb.
                    const glm::vec2 f = cells(seed, u, v, 3, 14);
                    h = f.x > 0.28F ? 0.85F + 0.08F * grain : 0.85F * f.x / 0.28F;
                    break;
                }
            }
            relief.at(column, row) = h;
        }
    }
    if (kind != Bark::Smooth) normalise(relief);
    return relief;
}

mesh::Image bark_picture(const mesh::Field& relief, float depth) {
    constexpr float kSlope = 1.2F;
    const int n = relief.columns;
    // The bark is as light as its colour.
    const float mean =
        std::accumulate(relief.samples.begin(), relief.samples.end(), 0.0F) / static_cast<float>(relief.samples.size());
    mesh::Image picture(n, n, 4);
    const auto byte = [](float unit) {
        return static_cast<std::uint8_t>(std::clamp(128.0F + 127.0F * unit, 0.0F, 255.0F));
    };
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const float across = relief.at((x + n - 1) % n, y) - relief.at((x + 1) % n, y);
            const float along = relief.at(x, (y + n - 1) % n) - relief.at(x, (y + 1) % n);
            std::uint8_t* p = picture.pixel(x, y);
            p[0] = byte(kSlope * depth * across);
            p[1] = byte(kSlope * depth * along);
            p[2] = byte(depth * 0.85F * (relief.at(x, y) - mean));
            p[3] = 255;
        }
    }
    return picture;
}

}  // namespace quadrat::synthesis::trees
