// SPDX-License-Identifier: Apache-2.0
// Kajiya & Von Herzen 1984: brightness is gathered along the ray from the eye, of light that was weakened along its own
// way through the cloud. Ours goes outward through columns of cloud, each with a flat base and a top of its own, and
// touches only the rows of the picture that a column fills.
#include "synthesis/sky/cloudscape.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::sky {
namespace {

constexpr int kLevels = 10;          // of the light's grid, from base to top
constexpr int kSide = 128;           // of it, over the tile
constexpr float kRelief = 1.3F;      // of thick clouds' undersides, in their light
constexpr float kBrightest = 0.16F;  // thinner than this nothing is told apart: holes would be lamps
constexpr float kHeaped = 0.22F;     // light of a bulge, shade of a crease: a heap's flank is no wall
constexpr float kStep = 1.036F;      // of the distance from one slab to the next
constexpr std::size_t kAround = 4;   // halvings of the tile: sixteenths of a cloud
constexpr float kGapHeight = 0.24F;  // sine of how high a whole gap reaches

// A picture that repeats, between its samples.
float tiled(const mesh::Field& field, glm::vec2 at) {
    const int mask = field.columns - 1;
    const float u = (at.x - std::floor(at.x)) * static_cast<float>(field.columns);
    const float v = (at.y - std::floor(at.y)) * static_cast<float>(field.rows);
    const int x = static_cast<int>(u);
    const int y = static_cast<int>(v);
    const float tx = u - static_cast<float>(x);
    const float ty = v - static_cast<float>(y);
    const auto sample = [&](int dx, int dy) { return field.at((x + dx) & mask, (y + dy) & mask); };
    const float above = sample(0, 0) + tx * (sample(1, 0) - sample(0, 0));
    return above + ty * (sample(0, 1) + tx * (sample(1, 1) - sample(0, 1)) - above);
}

mesh::Field halved(const mesh::Field& field) {
    mesh::Field half(field.columns / 2, field.rows / 2);
    for (int y = 0; y < half.rows; ++y)
        for (int x = 0; x < half.columns; ++x)
            half.at(x, y) = 0.25F * (field.at(2 * x, 2 * y) + field.at(2 * x + 1, 2 * y) + field.at(2 * x, 2 * y + 1) +
                                     field.at(2 * x + 1, 2 * y + 1));
    return half;
}

// How tall a column of this optical depth is, to the tallest: domes that stand up steeply from their rims.
float rise_of(float depth) { return 1.0F - std::exp(-0.55F * depth); }

// Extinction times the tallest column's height. Thin cloud stays thin.
float thickness_of(float depth) { return 1.1F * std::min(depth, 1.0F) + 1.6F * depth; }

// How deep in cloud, toward the light, each point of the tile's volume lies.
class LightGrid {
  public:
    LightGrid(const mesh::Field& depth, const CloudscapeShape& shape) {
        mesh::Field coarse = depth;
        while (coarse.columns > kSide) coarse = halved(coarse);
        side_ = coarse.columns;
        const float level_m = shape.tall_m / kLevels;
        // No lower than so: farther than a few clouds no shadow is told apart.
        const float up = std::max(shape.light.y, 0.30F);
        const glm::vec2 flat = glm::vec2{shape.light.x, shape.light.z} * (level_m / up);
        const glm::vec2 across{-shape.along.y, shape.along.x};
        const glm::vec2 step = glm::vec2{glm::dot(flat, across) / shape.tile_m,
                                         glm::dot(flat, shape.along) / (shape.tile_m * shape.stretch)};
        const float way_m = level_m / up;
        levels_.assign(kLevels + 1, mesh::Field(side_, side_));
        for (int level = kLevels - 1; level >= 0; --level) {
            const mesh::Field& above = levels_[static_cast<std::size_t>(level + 1)];
            mesh::Field& here = levels_[static_cast<std::size_t>(level)];
            const float height = (static_cast<float>(level) + 0.5F) / kLevels;
            for (int y = 0; y < side_; ++y) {
                for (int x = 0; x < side_; ++x) {
                    const glm::vec2 at = glm::vec2{x, y} / static_cast<float>(side_);
                    const float deep = tiled(coarse, at + 0.5F * step);
                    const float within = std::clamp((rise_of(deep) - height) * kLevels + 0.5F, 0.0F, 1.0F);
                    here.at(x, y) = tiled(above, at + step) + within * thickness_of(deep) * way_m / shape.tall_m;
                }
            }
        }
    }
    // height: 0 base to 1 the tallest top.
    float before(glm::vec2 at, float height) const {
        const float level = std::clamp(height, 0.0F, 1.0F) * kLevels;
        const auto low = std::min(static_cast<std::size_t>(level), static_cast<std::size_t>(kLevels - 1));
        const float below = tiled(levels_[low], at);
        return below + (level - static_cast<float>(low)) * (tiled(levels_[low + 1], at) - below);
    }

  private:
    int side_ = 0;
    std::vector<mesh::Field> levels_;
};

// The eye is used to a dark sky: under thick clouds it sees which parts of them are thinner, not that all are thick. Of
// the optical depth, what counts for the light that comes down through it.
float told_apart(const mesh::Field& depth) {
    constexpr float kMean = 1.7F;  // of what is cloud
    constexpr float kCloud = 0.3F;
    double sum = 0;
    std::size_t count = 0;
    for (const float d : depth.samples) {
        if (d < kCloud) continue;
        sum += d;
        ++count;
    }
    return count > 0 ? kMean / std::max(static_cast<float>(sum / static_cast<double>(count)), kMean) : 1.0F;
}

// Bulges with creases between them, over the tile and finer and finer: what makes heaps of domes.
std::vector<mesh::Field> bulges_of(base::Seed seed) {
    constexpr int kSamples = 256;
    constexpr int kBulges = 22;
    mesh::Field bulges(kSamples, kSamples);
    const noise::Key key(seed);
    std::vector<float> us(kSamples);
    for (int x = 0; x < kSamples; ++x)
        us[static_cast<std::size_t>(x)] = static_cast<float>(x) * (static_cast<float>(kBulges) / kSamples);
    for (int y = 0; y < kSamples; ++y) {
        const std::vector<float> vs(us.size(), us[static_cast<std::size_t>(y)]);
        noise::fbm_tiled(key, us, vs, std::span(bulges.samples).subspan(bulges.index(0, y), us.size()), kBulges,
                         {.count = 3, .gain = 0.55F, .ridged = -1.0F});
    }
    for (float& b : bulges.samples) b = 1.7F * b + 0.75F;  // about -1 to 1
    std::vector<mesh::Field> finest_first{std::move(bulges)};
    while (finest_first.back().columns > 16) finest_first.push_back(halved(finest_first.back()));
    return finest_first;
}

struct Rows {
    std::vector<float> rise;  // of each row's ray for a metre outward, with how clouds bend down
};

Rows rows_of(int height) {
    Rows rows;
    for (int y = 0; y < height; ++y) {
        const glm::vec3 d =
            scene::cloudscape_direction({0.5F, (static_cast<float>(y) + 0.5F) / static_cast<float>(height)});
        rows.rise.push_back((d.y + scene::kBendsDown) / std::max(std::hypot(d.x, d.z), 1.0e-3F));
    }
    return rows;
}

// One slab of a column of the picture: what cloud stands between two distances.
struct Slab {
    float near_m, far_m;
    glm::vec2 at;  // in the tile
    float depth;   // optical
    float around;  // the same, of what is about it: no heap stands as a spire
    const mesh::Field* bulges;
    float told_apart;  // share of the depth
};

class Column {
  public:
    explicit Column(std::size_t rows) : left_(rows, 1.0F), light_(rows, 0.0F) {}

    void add(const Slab& slab, const CloudscapeShape& shape, const LightGrid& light, const Rows& rows) {
        // As far as bulges may swell it.
        const float swelling = shape.swelling * std::min(slab.depth, 1.3F);
        const float most = 1.3F * slab.around + 0.3F;
        const float rise = rise_of(std::min(slab.depth + swelling, most));
        const float top_m = shape.base_m + rise * shape.tall_m;
        const float per_m = thickness_of(slab.depth) / shape.tall_m;
        const float mid_m = 0.5F * (slab.near_m + slab.far_m);
        const auto first = std::ranges::upper_bound(rows.rise, shape.base_m / slab.far_m) - rows.rise.begin();
        // Light at two heights of this place serves all its rows.
        const float low = light.before(slab.at, 0.0F);
        const float middle = light.before(slab.at, 0.5F * rise);
        const float high = light.before(slab.at, 0.96F * rise);
        // What comes down through the whole of it.
        const float through =
            std::exp(-0.45F * slab.told_apart * slab.depth) * (0.8F + 0.35F * tiled(*slab.bulges, slab.at));
        const float relief = kRelief * (1.0F - slab.told_apart) * std::min(through - 0.42F, kBrightest);
        const float tiles_per_m = 1.0F / shape.tile_m;
        for (auto y = static_cast<std::size_t>(first); y < rows.rise.size(); ++y) {
            const float t = rows.rise[y];
            if (t * slab.near_m > top_m) break;
            if (left_[y] < 0.004F) continue;
            const float enters_m = std::max(slab.near_m, shape.base_m / t);
            const float leaves_m = std::min(slab.far_m, top_m / t);
            if (leaves_m <= enters_m) continue;
            const float height = std::clamp((t * mid_m - shape.base_m) / shape.tall_m, 0.0F, rise);
            const float share = height / std::max(rise, 1.0e-3F);
            // Bulges of another height are others.
            const float over_m = height * shape.tall_m * tiles_per_m;
            const glm::vec2 aslant = over_m * glm::vec2{0.9F, 0.8F};
            const float bulge = 0.62F * (tiled(*slab.bulges, slab.at + aslant) + tiled(*slab.bulges, slab.at - aslant));
            const float own_rise = rise_of(std::clamp(slab.depth + swelling * bulge, 0.0F, most));
            const float within = std::clamp((own_rise - height) * 14.0F + 0.5F, 0.0F, 1.0F);
            if (within <= 0) continue;
            const float passed = std::exp(-within * per_m * (leaves_m - enters_m) * std::sqrt(1.0F + t * t));
            const float before =
                share < 0.5F ? glm::mix(low, middle, 2.0F * share) : glm::mix(middle, high, 2.0F * share - 1.0F);
            // Near the light much goes on that was scattered forward; the tops have all of the sky.
            const float lit = 0.62F * std::exp(-0.85F * before) + 0.20F * std::exp(-0.16F * before) +
                              0.22F * share * rise + 0.34F * through + kHeaped * bulge * std::min(3.0F * share, 1.0F) +
                              relief;
            light_[y] += left_[y] * (1.0F - passed) * std::clamp(lit, 0.0F, 1.0F);
            left_[y] *= passed;
        }
    }
    float opacity(std::size_t row) const { return 1.0F - left_[row]; }
    float light(std::size_t row) const { return light_[row]; }

  private:
    std::vector<float> left_;
    std::vector<float> light_;
};

// How far off clouds end over this bearing: not along a line.
float end_m(const CloudscapeShape& shape, float bearing) {
    const float ragged = 1.0F + 0.16F * std::sin(3.0F * bearing + 1.0F) + 0.09F * std::sin(8.0F * bearing) +
                         0.05F * std::sin(21.0F * bearing + 2.0F);
    return shape.base_m / (kGapHeight * shape.gap * ragged + scene::kBendsDown);
}

void add_air(const CloudscapeShape& shape, scene::Cloudscape& picture);

}  // namespace

float closed_over_gap(float gap, float sine_of_height) {
    return glm::smoothstep(0.25F * kGapHeight * gap, 1.15F * kGapHeight * gap + 1.0e-4F, sine_of_height);
}

scene::Cloudscape make_cloudscape(const CloudscapeShape& shape, int width, int height) {
    scene::Cloudscape picture(width, height, 2);
    const LightGrid light(shape.depth, shape);
    const Rows rows = rows_of(height);
    const float apart = told_apart(shape.depth);
    std::vector<mesh::Field> depths{shape.depth};
    while (depths.back().columns > 16) depths.push_back(halved(depths.back()));
    const std::vector<mesh::Field> bulges = bulges_of(shape.seed);
    const float px_m = shape.tile_m / static_cast<float>(shape.depth.columns);
    const glm::vec2 across{-shape.along.y, shape.along.x};
    const float first_m = 0.12F * shape.base_m;
    const float last_m = (shape.base_m + shape.tall_m) / rows.rise.front();
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, width, 16), [&](const auto& columns) {
        for (int x = columns.begin(); x != columns.end(); ++x) {
            const glm::vec3 d =
                scene::cloudscape_direction({(static_cast<float>(x) + 0.5F) / static_cast<float>(width), 0.0F});
            const glm::vec2 way = glm::normalize(glm::vec2{d.x, d.z});
            const glm::vec2 tile_way{glm::dot(way, across) / shape.tile_m,
                                     glm::dot(way, shape.along) / (shape.tile_m * shape.stretch)};
            const float end = shape.gap > 0 ? end_m(shape, std::atan2(d.x, -d.z)) : 2.0F * last_m;
            Column column(rows.rise.size());
            for (float near_m = first_m; near_m < std::min(last_m, 1.3F * end); near_m *= kStep) {
                Slab slab{near_m, near_m * kStep, tile_way * (near_m * 0.5F * (1.0F + kStep)), 0, 0, nullptr, apart};
                const float levels = std::log2(std::max((slab.far_m - slab.near_m) / (2.0F * px_m), 1.0F));
                const auto level = std::min(static_cast<std::size_t>(levels), depths.size() - 1);
                slab.depth = tiled(depths[level], slab.at);
                slab.around = tiled(depths[std::min(std::max(level, kAround), depths.size() - 1)], slab.at);
                const std::size_t coarser = level > 0 ? level - 1 : 0;  // of a finer picture
                slab.bulges = &bulges[std::min(coarser, bulges.size() - 1)];
                if (shape.gap > 0) slab.depth *= 1.0F - glm::smoothstep(0.75F * end, 1.15F * end, near_m);
                if (slab.depth > 0.02F) column.add(slab, shape, light, rows);
            }
            for (int y = 0; y < height; ++y) {
                const auto row = static_cast<std::size_t>(y);
                picture.pixel(x, y)[0] = static_cast<std::uint8_t>(255.0F * column.opacity(row) + 0.5F);
                picture.pixel(x, y)[1] = static_cast<std::uint8_t>(255.0F * std::min(column.light(row), 1.0F) + 0.5F);
            }
        }
    });
    if (shape.beams + shape.halo > 0) add_air(shape, picture);
    return picture;
}

namespace {

// A ring of 22 degrees, as prisms of ice make it: sharp within, fading outward.
float halo_at(float cosine) {
    const float off = std::acos(std::clamp(cosine, -1.0F, 1.0F)) - 0.384F;
    return off < 0 ? std::exp(-off * off / 0.00012F) : std::exp(-off / 0.035F);
}

// Directions of a picture's pixels, whose bearings and heights do not hang on each other.
class Directions {
  public:
    Directions(int width, int height) {
        for (int x = 0; x < width; ++x) {
            const glm::vec3 d =
                scene::cloudscape_direction({(static_cast<float>(x) + 0.5F) / static_cast<float>(width), 0.0F});
            ways_.emplace_back(d.x, d.z);
        }
        for (int y = 0; y < height; ++y)
            ups_.push_back(
                scene::cloudscape_direction({0.5F, (static_cast<float>(y) + 0.5F) / static_cast<float>(height)}).y);
    }
    glm::vec3 at(int x, int y) const {
        const float up = ups_[static_cast<std::size_t>(y)];
        const glm::vec2 way = ways_[static_cast<std::size_t>(x)] * std::sqrt(1.0F - up * up);
        return {way.x, up, way.y};
    }

  private:
    std::vector<glm::vec2> ways_;
    std::vector<float> ups_;
};

constexpr float kWide = 0.62F;  // cosine of how far from the disc its light is seen in the air

// How open the sky is on the way from the disc to a direction, by a picture of its clouds.
float open_between(const scene::Cloudscape& clouds, const glm::vec3& disc, const glm::vec3& direction) {
    constexpr int kSteps = 20;
    float open = 0;
    for (int i = 0; i < kSteps; ++i) {
        const float t = (static_cast<float>(i) + 0.5F) / kSteps;
        const glm::vec2 at = scene::cloudscape_at(glm::normalize(glm::mix(disc, direction, t)));
        const int x = std::clamp(static_cast<int>(at.x * static_cast<float>(clouds.width)), 0, clouds.width - 1);
        const int y = std::clamp(static_cast<int>(at.y * static_cast<float>(clouds.height)), 0, clouds.height - 1);
        open += 1.0F - static_cast<float>(*clouds.pixel(x, y)) / 255.0F;
    }
    return open / kSteps;
}

// Beams, coarse, for they are soft: light that comes between clouds is seen along lines from where it comes, brighter
// than what they shade. None in an open sky and none in a closed one.
mesh::Field beams_of(const CloudscapeShape& shape, const scene::Cloudscape& clouds) {
    constexpr int kCoarser = 5;
    mesh::Field beams(clouds.width / kCoarser, clouds.height / kCoarser);
    if (shape.beams <= 0) return beams;
    const Directions directions(beams.columns, beams.rows);
    oneapi::tbb::parallel_for(0, beams.rows, [&](int y) {
        for (int x = 0; x < beams.columns; ++x) {
            const glm::vec3 d = directions.at(x, y);
            const float near = (glm::dot(d, shape.disc) - kWide) / (1.0F - kWide);
            if (near <= 0) continue;
            const float open = open_between(clouds, shape.disc, d);
            // Close to the disc its own glare is all that the eye can take.
            const float beside = near * near * (1.0F - 0.85F * near * near);
            beams.at(x, y) = shape.beams * beside * open * (1.0F - open) * 2.2F;
        }
    });
    return beams;
}

void add_air(const CloudscapeShape& shape, scene::Cloudscape& picture) {
    const mesh::Field beams = beams_of(shape, picture);
    const Directions directions(picture.width, picture.height);
    const float columns = static_cast<float>(beams.columns) / static_cast<float>(picture.width);
    const float rows = static_cast<float>(beams.rows) / static_cast<float>(picture.height);
    oneapi::tbb::parallel_for(0, picture.height, [&](int y) {
        for (int x = 0; x < picture.width; ++x) {
            const float cosine = glm::dot(directions.at(x, y), shape.disc);
            if (cosine < kWide) continue;
            std::uint8_t* pixel = picture.pixel(x, y);
            const float beam = mesh::sample(beams, (static_cast<float>(x) + 0.5F) * columns - 0.5F,
                                            (static_cast<float>(y) + 0.5F) * rows - 0.5F);
            const float ring = shape.halo > 0 ? 0.35F * shape.halo * halo_at(cosine) : 0.0F;
            const float clear = 1.0F - 0.6F * static_cast<float>(pixel[0]) / 255.0F;
            pixel[1] = static_cast<std::uint8_t>(
                std::min(static_cast<float>(pixel[1]) + 255.0F * (beam + ring) * clear + 0.5F, 255.0F));
        }
    });
}

}  // namespace

}  // namespace quadrat::synthesis::sky
