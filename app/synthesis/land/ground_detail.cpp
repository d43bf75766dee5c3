// SPDX-License-Identifier: Apache-2.0
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "base/seed.hpp"
#include "synthesis/land/ground.hpp"
#include "synthesis/noise/gradient.hpp"
#include "synthesis/noise/lateral_inhibition.hpp"

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

// Ripples of sand, steep where the wind has passed them, that run into one another.
Tile ripple_tile(base::Seed seed, int side) {
    constexpr int kRipples = 15;
    Tile tile(side, side);
    const noise::Key bends(seed.child("ripples"));
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, side, 32), [&](const auto& rows) {
        std::vector<float> bend(static_cast<std::size_t>(side));
        for (int y = rows.begin(); y != rows.end(); ++y) {
            noise_row(bends, side, y, 3, {.count = 3, .gain = 0.5F}, bend);
            const float v = static_cast<float>(y) / static_cast<float>(side);
            for (int x = 0; x < side; ++x) {
                const float turn = kRipples * v + 1.6F * bend[static_cast<std::size_t>(x)];
                const float t = turn - std::floor(turn);
                const float rise = t < 0.72F ? t / 0.72F : (1 - t) / 0.28F;
                tile.at(x, y) = 2.4F * (rise * rise * (3 - 2 * rise) - 0.5F);
            }
        }
    });
    return tile;
}

Tile mixed(Tile one, const Tile& other, float share) {
    if (share <= 0) return one;
    for (std::size_t i = 0; i < one.samples.size(); ++i) one.samples[i] += share * (other.samples[i] - one.samples[i]);
    return one;
}

// Blocks of stone: cells about jittered points, each a plane of its own tilt, with clefts where two meet (Worley 1996).
// They are drawn out along x, as beds break.
class Blocks {
  public:
    Blocks(base::Seed seed, int columns, int rows) : columns_(columns), rows_(rows) {
        base::RandomStream random(seed);
        for (int i = 0; i < columns * rows; ++i)
            blocks_.push_back({random.between(0.08F, 0.92F), random.between(0.08F, 0.92F), random.between(-1.0F, 1.0F),
                               random.between(-1.0F, 1.0F), random.between(-1.0F, 1.0F)});
    }

    // At u, v of the tile, 0 to 1: the height of its plane, and how far it is from the cleft, in cells.
    struct Found {
        float plane, to_cleft;
    };
    Found at(float u, float v) const {
        const float x = u * static_cast<float>(columns_);
        const float y = v * static_cast<float>(rows_);
        const int column = static_cast<int>(std::floor(x));
        const int row = static_cast<int>(std::floor(y));
        float nearest = 9, second = 9, plane = 0;
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const Block& b = block(column + dx, row + dy);
                const float east = x - static_cast<float>(column + dx) - b.x;
                const float south = y - static_cast<float>(row + dy) - b.y;
                const float apart = east * east + south * south;
                second = std::min(second, std::max(apart, nearest));
                if (apart >= nearest) continue;
                nearest = apart;
                plane = 0.5F * b.height + b.rise_x * east + b.rise_y * south;
            }
        }
        return {plane, std::sqrt(second) - std::sqrt(nearest)};
    }

  private:
    struct Block {
        float x, y;            // in its cell
        float height;          // of the plane's middle
        float rise_x, rise_y;  // a cell
    };
    const Block& block(int column, int row) const {
        const int c = (column + columns_) % columns_;
        const int r = (row + rows_) % rows_;
        return blocks_[static_cast<std::size_t>(r * columns_ + c)];
    }
    int columns_, rows_;
    std::vector<Block> blocks_;
};

// Blocks broken into smaller ones, clefts between, and chips on them.
Tile stone_tile(base::Seed seed, int side) {
    Tile tile(side, side);
    const Blocks large(seed.child("blocks"), 3, 6);
    const Blocks small(seed.child("splinters"), 8, 17);
    const noise::Key bends(seed.child("clefts"));
    const noise::Key chips(seed.child("chips"));
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, side, 32), [&](const auto& rows) {
        const auto width = static_cast<std::size_t>(side);
        std::vector<float> bend(width), fine(width);
        const float per_px = 1.0F / static_cast<float>(side);
        for (int y = rows.begin(); y != rows.end(); ++y) {
            const auto out = std::span(tile.samples).subspan(tile.index(0, y), width);
            noise_row(bends, side, y, 5, {.count = 3, .gain = 0.55F}, bend);
            noise_row(chips, side, y, 20, {.count = 3, .gain = 0.65F}, fine);
            for (std::size_t x = 0; x < width; ++x) {
                const float u = static_cast<float>(x) * per_px + 0.035F * bend[x];
                const float v = static_cast<float>(y) * per_px + 0.03F * fine[x];
                const Blocks::Found big = large.at(u, v);
                const Blocks::Found little = small.at(u, v);
                const float clefts =
                    1.1F * std::max(1 - big.to_cleft / 0.13F, 0.0F) + 0.5F * std::max(1 - little.to_cleft / 0.2F, 0.0F);
                out[x] = 1.2F * big.plane + 0.45F * little.plane + 0.5F * fine[x] + 0.4F * bend[x] - clefts;
            }
        }
    });
    double mean = 0;
    for (const float h : tile.samples) mean += h;
    for (float& h : tile.samples) h -= static_cast<float>(mean / static_cast<double>(tile.samples.size()));
    return tile;
}

// Where each begins that runs into its neighbours, side to side of a tile one apart: the peaks of lateral inhibition.
std::vector<glm::vec2> centres_of_plates(base::Seed seed) {
    constexpr int kSide = 60;
    std::vector<glm::vec2> centres;
    for (const glm::ivec2 peak : noise::peaks_of(noise::inhibited({}, seed, kSide)))
        centres.push_back((glm::vec2(peak) + 0.5F) / static_cast<float>(kSide));
    return centres;
}

// The nearest two of them on the torus.
struct Nearest {
    float first = 9, second = 9;
    std::size_t centre = 0;
};
Nearest nearest_of(const std::vector<glm::vec2>& centres, glm::vec2 at) {
    Nearest found;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        glm::vec2 d = at - centres[i];
        d -= glm::round(d);
        const float apart = glm::dot(d, d);
        found.second = std::min(found.second, std::max(apart, found.first));
        if (apart >= found.first) continue;
        found.first = apart;
        found.centre = i;
    }
    found.first = std::sqrt(found.first);
    found.second = std::sqrt(found.second);
    return found;
}

}  // namespace

// As in the reaction of Belousov & Zhabotinsky waves run out from centres, all at once, and die where two meet: there
// lie the edges of Voronoi cells (Adamatzky & de Lacy Costello, 2002), and the mud tears. The centres are as far apart
// as lateral inhibition sets them; how fast a wave runs differs with the ground, so that no crack is straight. When
// each arrives is worked out instead of stepped.
mesh::Field mud_tile(base::Seed seed, int side_px) {
    Tile tile(side_px, side_px);
    const std::vector<glm::vec2> centres = centres_of_plates(seed.child("plates"));
    const float apart = 1 / std::sqrt(static_cast<float>(std::max<std::size_t>(centres.size(), 1)));
    const noise::Key bends(seed.child("tears"));
    const noise::Key crumbs(seed.child("crumbs"));
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, side_px, 16), [&](const auto& rows) {
        const auto width = static_cast<std::size_t>(side_px);
        std::vector<float> bend(width), fine(width);
        for (int y = rows.begin(); y != rows.end(); ++y) {
            noise_row(bends, side_px, y, 9, {.count = 3, .gain = 0.6F}, bend);
            noise_row(crumbs, side_px, y, 28, {.count = 2, .gain = 0.6F}, fine);
            for (int x = 0; x < side_px; ++x) {
                const auto i = static_cast<std::size_t>(x);
                const glm::vec2 at =
                    (glm::vec2{static_cast<float>(x), static_cast<float>(y)} + 0.5F) / static_cast<float>(side_px) +
                    apart * glm::vec2{0.35F * bend[i], 0.3F * fine[i]};
                const Nearest n = nearest_of(centres, at);
                const float to_crack = (n.second - n.first) / apart;
                const float tone = base::unit_of(base::hash_of(seed, static_cast<int>(n.centre), 7)) - 0.5F;
                // A plate's rim has curled up; in a crack it is dark.
                const float torn = 1 - glm::smoothstep(0.05F, 0.17F, to_crack + 0.06F * bend[i]);
                const float rim = 1 - glm::smoothstep(0.2F, 0.75F, to_crack);
                tile.at(x, y) = 0.35F + 0.3F * rim + 0.5F * tone + 0.3F * fine[i] - 2.6F * torn;
            }
        }
    });
    return tile;
}

GroundDetail ground_detail(base::Seed seed, int side_px, const DetailLook& look) {
    GroundDetail detail{mesh::Image(side_px, side_px, 2), mesh::Image(side_px, side_px, 4)};
    Tile soft = soft_tile(seed, side_px);
    if (look.cracked > 0) soft = mixed(std::move(soft), mud_tile(seed, side_px), look.cracked);
    if (look.sandy > 0) soft = mixed(std::move(soft), ripple_tile(seed, side_px), look.sandy);
    const Tile tiles[2] = {std::move(soft), stone_tile(seed, side_px)};
    // Of a relief of a thirtieth of the tile, per pixel.
    const float slope_of = look.bumps * static_cast<float>(side_px) / 30.0F;
    const auto wrapped = [side_px](int i) { return (i + side_px) % side_px; };
    for (std::size_t kind = 0; kind < 2; ++kind) {
        const Tile& tile = tiles[kind];
        oneapi::tbb::parallel_for(0, side_px, [&](int y) {
            for (int x = 0; x < side_px; ++x) {
                const float east = 0.5F * slope_of * (tile.at(wrapped(x + 1), y) - tile.at(wrapped(x - 1), y));
                const float south = 0.5F * slope_of * (tile.at(x, wrapped(y + 1)) - tile.at(x, wrapped(y - 1)));
                detail.grain.pixel(x, y)[kind] = byte_of(128.0F + 62.0F * look.contrast * tile.at(x, y));
                detail.slopes.pixel(x, y)[2 * kind] = byte_of(128.0F + 127.0F * east);
                detail.slopes.pixel(x, y)[2 * kind + 1] = byte_of(128.0F + 127.0F * south);
            }
        });
    }
    return detail;
}

}  // namespace quadrat::synthesis::land
