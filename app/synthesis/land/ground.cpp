// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/ground.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "scene/colour.hpp"
#include "scene/land.hpp"
#include "synthesis/land/erosion.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr int kGrainSide = 256;  // pixels of the repeating fine variation

// Written with min and max, so that whole rows of it become vector instructions.
inline float unit(float x) { return std::min(std::max(x, 0.0F), 1.0F); }
inline float smooth(float low, float high, float x) {
    const float t = unit((x - low) * (1.0F / (high - low)));
    return t * t * (3.0F - 2.0F * t);
}

// What the ground's colour hangs on, a value a pixel of one row.
struct Row {
    explicit Row(std::size_t width) {
        for (auto* values : {&height_m, &shore_m, &slope, &hollow, &moisture, &shade, &road_m, &patch, &grain, &l, &a,
                             &b, &soft, &hard})
            values->resize(width);
    }
    std::vector<float> height_m;
    std::vector<float> shore_m;  // height over the nearest water
    std::vector<float> slope;    // rise over run
    std::vector<float> hollow;   // more than 0 in hollows, less than 0 on ridges
    std::vector<float> moisture;
    std::vector<float> shade;       // slope toward the north, rise over run
    std::vector<float> road_m;      // to the edge of a road
    std::vector<float> patch;       // quiet large patches, about -1 to 1
    std::vector<float> grain;       // fine variation, about -1 to 1
    std::vector<float> l, a, b;     // OKLab
    std::vector<float> soft, hard;  // how far its grain is that of grass and earth, how far that of stone
};

// A material: its colour and its grain.
struct Material {
    glm::vec3 lab;
    float soft = 0;
    float hard = 0;
};

// Laid over what is there by a weight a pixel.
template <typename Weight>
void mix_in(Row& row, const Material& m, const Weight& weight) {
    const std::size_t width = row.l.size();
    for (std::size_t i = 0; i < width; ++i) {
        const float w = weight(i);
        row.l[i] += w * (m.lab.x - row.l[i]);
        row.a[i] += w * (m.lab.y - row.a[i]);
        row.b[i] += w * (m.lab.z - row.b[i]);
        row.soft[i] += w * (m.soft - row.soft[i]);
        row.hard[i] += w * (m.hard - row.hard[i]);
    }
}

// A soft wave of period 2 in place of a sine: -1 to 1.
inline float wave(float x) {
    const float turns = x - 2.0F * static_cast<float>(static_cast<std::int32_t>(0.5F * x + 4096.0F) - 4096);
    const float t = std::abs(turns - 1.0F);
    return 2.0F * t * t * (3.0F - 2.0F * t) - 1.0F;
}

// The genes of the ground, and what follows from them for this land.
struct GroundLook {
    scene::LandParameters p;
    float beach_top_m;
    float snow_line_m;  // far above everything where no snow lies

    explicit GroundLook(const scene::LandParameters& parameters)
        : p(parameters),
          beach_top_m(0.05F + p.ground_beach * std::clamp(0.014F * p.land_relief_m, 0.25F, 1.6F)),
          snow_line_m(p.land_relief_m < 140.0F
                          ? 1.0e6F
                          : 10.0F + p.ground_snow_line * p.land_relief_m * (1.0F - p.land_sea_level)) {}
};

Material material(const glm::vec3& linear, float soft, float hard) {
    return {scene::oklab_from_linear(linear), soft, hard};
}

// What grows: dry ground, greener where it is moist or hollow, heath in patches.
void paint_growth(Row& r, const Palette& palette, const GroundLook& look) {
    const Material dry = material(palette.dry, 1, 0);
    std::fill(r.l.begin(), r.l.end(), dry.lab.x);
    std::fill(r.a.begin(), r.a.end(), dry.lab.y);
    std::fill(r.b.begin(), r.b.end(), dry.lab.z);
    std::fill(r.soft.begin(), r.soft.end(), dry.soft);
    std::fill(r.hard.begin(), r.hard.end(), dry.hard);
    const float* p = r.patch.data();
    const float* g = r.grain.data();
    const float* hollow = r.hollow.data();
    const float* moist = r.moisture.data();
    const float lushness = 1.1F * look.p.ground_lushness - 0.35F * look.p.ground_moisture;
    const float heath = look.p.ground_heath;
    const float thirst = 2.0F * look.p.ground_moisture;
    mix_in(r, material(palette.lush, 1, 0), [=](std::size_t i) {
        return smooth(-0.9F, 0.9F, 1.2F * hollow[i] + 0.9F * p[i] + 0.2F * g[i] + thirst * moist[i] + lushness);
    });
    mix_in(r, material(palette.heath, 1, 0), [=](std::size_t i) {
        return heath * smooth(0.25F, 0.7F, 0.3F * g[i] - p[i]) * (1.0F - 0.8F * unit(1.6F * moist[i] - 0.4F));
    });
}

// What shows through where it is too steep to grow: earth, scree, then rock in beds.
void paint_stone(Row& r, const Palette& palette, const GroundLook& look) {
    const float* h = r.height_m.data();
    const float* s = r.slope.data();
    const float* p = r.patch.data();
    const float* g = r.grain.data();
    const float* hollow = r.hollow.data();
    const float soil = look.p.ground_soil_slope;
    const float scree = look.p.ground_scree_slope;
    const float stone = look.p.ground_rock_slope;
    const float beds_per_m = 2.0F / look.p.ground_strata_m;
    const float contrast = 0.5F * look.p.ground_strata;
    // Crests are bare before slopes are.
    const auto steep = [=](std::size_t i, float wander) {
        return s[i] + wander * (0.5F * p[i] + 0.35F * g[i]) - 0.10F * std::min(hollow[i], 0.0F);
    };
    mix_in(r, material(palette.soil, 0.7F, 0.1F),
           [=](std::size_t i) { return smooth(soil, soil + 0.24F, steep(i, 0.16F)); });
    mix_in(r, material(palette.scree, 0.2F, 0.7F),
           [=](std::size_t i) { return smooth(scree, scree + 0.22F, steep(i, 0.12F)); });
    const auto strata = [=](std::size_t i) { return 0.5F + contrast * wave(beds_per_m * h[i] + p[i] + 0.25F * g[i]); };
    const auto rock = [=](std::size_t i) { return smooth(stone, stone + 0.31F, steep(i, 0.10F)); };
    mix_in(r, material(palette.rock_dark, 0, 1), rock);
    mix_in(r, material(palette.rock_light, 0, 1), [=](std::size_t i) { return rock(i) * strata(i); });
}

// What lies on it: sand and mud by the water, a road's gravel, snow.
void paint_cover(Row& r, const Palette& palette, const GroundLook& look) {
    const float* h = r.height_m.data();
    const float* shore = r.shore_m.data();
    const float* s = r.slope.data();
    const float* p = r.patch.data();
    const float* g = r.grain.data();
    const float* moist = r.moisture.data();
    const float* shade = r.shade.data();
    const float* hollow = r.hollow.data();
    const float beach_top_m = look.beach_top_m;
    const float snow_line_m = look.snow_line_m;
    const float broken = look.p.ground_snow_patchiness;
    const float aspect_m = 26.0F * look.p.ground_snow_aspect;
    const float mud = 0.7F * unit(look.p.marsh_share) + 0.25F;
    const glm::vec3 earth = scene::shifted_colour(palette.soil, 0.72F, 0.8F);
    mix_in(r, material(earth, 0.25F, 0), [=](std::size_t i) {
        return mud * smooth(0.75F, 1.0F, moist[i] + 0.15F * p[i]) * (1.0F - smooth(0.12F, 0.3F, s[i]));
    });
    mix_in(r, material(palette.sand, 0.25F, 0), [=](std::size_t i) {
        const float top_m = beach_top_m * (1.0F + 0.7F * p[i] + 0.15F * g[i]);
        return (1.0F - smooth(0.0F, 0.9F * beach_top_m, shore[i] - top_m)) * (1.0F - smooth(0.5F, 0.8F, s[i]));
    });
    const float* road = r.road_m.data();
    const glm::vec3 gravel = scene::mix_colours(palette.sand, palette.scree, 0.5F);
    mix_in(r, material(gravel, 0.3F, 0.35F),
           [=](std::size_t i) { return 0.9F - 0.9F * smooth(-0.5F, 0.9F, road[i] + 0.45F * g[i]); });
    mix_in(r, material(palette.snow, 0.12F, 0), [=](std::size_t i) {
        const float line_m = snow_line_m - aspect_m * std::min(std::max(shade[i], -0.6F), 0.6F) - 5.0F * hollow[i];
        return smooth(-10.0F, 16.0F, h[i] - line_m + broken * (7.0F * p[i] + 5.0F * g[i])) *
               (1.0F - smooth(0.75F, 1.1F, s[i]));
    });
}

void paint(Row& r, const Palette& palette, const GroundLook& look) {
    paint_growth(r, palette, look);
    paint_stone(r, palette, look);
    paint_cover(r, palette, look);
    const float grain = 0.035F * look.p.ground_grain;
    const float wet_top_m = look.p.ground_wet_shore_m;
    for (std::size_t i = 0; i < r.l.size(); ++i) {
        // Wet ground is darker and of a deeper colour.
        const float wet = 1.0F - smooth(0.15F * wet_top_m, wet_top_m, r.shore_m[i] + 0.1F * wet_top_m * r.grain[i]);
        r.l[i] *= (1.0F + grain * r.grain[i]) * (1.0F - 0.20F * wet);
        r.a[i] *= 1.0F + 0.10F * wet;
        r.b[i] *= 1.0F + 0.10F * wet;
        r.soft[i] *= 1.0F - 0.5F * wet;
    }
}

// scene::linear_from_oklab and scene::srgb_byte for a whole row: arithmetic first, then the table.
void write_row(Row& r, std::uint8_t* pixel) {
    const std::size_t width = r.l.size();
    const auto root = [](float linear) { return 4096.0F * std::sqrt(unit(linear)) + 0.5F; };
    for (std::size_t i = 0; i < width; ++i) {
        const float l_ = r.l[i] + 0.3963377774F * r.a[i] + 0.2158037573F * r.b[i];
        const float m_ = r.l[i] - 0.1055613458F * r.a[i] - 0.0638541728F * r.b[i];
        const float s_ = r.l[i] - 0.0894841775F * r.a[i] - 1.2914855480F * r.b[i];
        const float l = l_ * l_ * l_;
        const float m = m_ * m_ * m_;
        const float s = s_ * s_ * s_;
        r.l[i] = root(4.0767416621F * l - 3.3077115913F * m + 0.2309699292F * s);
        r.a[i] = root(-1.2684380046F * l + 2.6097574011F * m - 0.3413193965F * s);
        r.b[i] = root(-0.0041960863F * l - 0.7034186147F * m + 1.7076147010F * s);
        r.patch[i] = 255.0F * (1.0F - smooth(0.15F, 0.9F, r.shore_m[i]));
    }
    const auto& bytes = scene::srgb_bytes_by_root();
    for (std::size_t i = 0; i < width; ++i, pixel += 4) {
        pixel[0] = bytes[static_cast<std::size_t>(static_cast<int>(r.l[i]))];
        pixel[1] = bytes[static_cast<std::size_t>(static_cast<int>(r.a[i]))];
        pixel[2] = bytes[static_cast<std::size_t>(static_cast<int>(r.b[i]))];
        pixel[3] = static_cast<std::uint8_t>(r.patch[i]);
    }
}

// Slope and hollowness at the land's own samples, from which pixels are interpolated.
struct Relief {
    mesh::Field slope;
    mesh::Field hollow;
    mesh::Field shade;

    Relief(const mesh::Field& height_m, float cell_m)
        : slope(height_m.columns, height_m.rows),
          hollow(height_m.columns, height_m.rows),
          shade(height_m.columns, height_m.rows) {
        const int last = height_m.columns - 1;
        const int reach = std::max(1, static_cast<int>(18.0F / cell_m + 0.5F));
        oneapi::tbb::parallel_for(0, height_m.rows, [&](int row) {
            const auto at = [&](int column, int line) {
                return height_m.at(std::clamp(column, 0, last), std::clamp(line, 0, last));
            };
            for (int column = 0; column <= last; ++column) {
                const float dx = at(column + 1, row) - at(column - 1, row);
                const float dz = at(column, row + 1) - at(column, row - 1);
                slope.at(column, row) = std::sqrt(dx * dx + dz * dz) / (2.0F * cell_m);
                shade.at(column, row) = dz / (2.0F * cell_m);
                const float around = 0.25F * (at(column - reach, row) + at(column + reach, row) +
                                              at(column, row - reach) + at(column, row + reach));
                hollow.at(column, row) = std::min(std::max((around - at(column, row)) / 3.5F, -1.0F), 1.0F);
            }
        });
    }
};

mesh::Field grain_tile(base::Seed seed) {
    mesh::Field tile(kGrainSide, kGrainSide);
    const noise::Key key(seed.child("grain"));
    std::vector<float> us(kGrainSide);
    for (int x = 0; x < kGrainSide; ++x) us[x] = 42.0F * static_cast<float>(x) / kGrainSide;
    for (int y = 0; y < kGrainSide; ++y) {
        const std::vector<float> vs(kGrainSide, us[y]);
        noise::fbm_tiled(key, us, vs, std::span(tile.samples).subspan(tile.index(0, y), us.size()), 42, {.count = 2});
    }
    for (float& g : tile.samples) g *= 1.6F;
    return tile;
}

// One row of pixels from a field, bilinear; per_px samples a pixel.
void interpolate(const mesh::Field& field, float row_at, float per_px, std::span<float> out) {
    const float y = std::clamp(row_at, 0.0F, static_cast<float>(field.rows - 1));
    const int y0 = std::min(static_cast<int>(y), field.rows - 2);
    const float ty = y - static_cast<float>(y0);
    const float* above = field.samples.data() + field.index(0, y0);
    const float* below = above + field.columns;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float x = (static_cast<float>(i) + 0.5F) * per_px;
        const int x0 = std::min(static_cast<int>(x), field.columns - 2);
        const float tx = x - static_cast<float>(x0);
        const float left = above[x0] + ty * (below[x0] - above[x0]);
        const float right = above[x0 + 1] + ty * (below[x0 + 1] - above[x0 + 1]);
        out[i] = left + tx * (right - left);
    }
}

}  // namespace

mesh::Field moisture_of(const mesh::Field& height_m, const std::vector<float>& drained_area_m2, float cell_m) {
    mesh::Field moisture(height_m.columns, height_m.rows);
    const int last = height_m.columns - 1;
    oneapi::tbb::parallel_for(0, height_m.rows, [&](int row) {
        for (int column = 0; column <= last; ++column) {
            const auto at = [&](int c, int r) {
                return height_m.at(std::clamp(c, 0, last), std::clamp(r, 0, height_m.rows - 1));
            };
            const float dx = at(column + 1, row) - at(column - 1, row);
            const float dz = at(column, row + 1) - at(column, row - 1);
            const float slope = std::sqrt(dx * dx + dz * dz) / (2.0F * cell_m);
            const float gathered = drained_area_m2[height_m.index(column, row)] / (cell_m * (slope + 0.02F));
            moisture.at(column, row) = std::clamp((std::log2(gathered) - 4.0F) / 9.0F, 0.0F, 1.0F);
        }
    });
    smooth(moisture, 2);
    smooth(moisture, 1);
    return moisture;
}

Ground lay_ground(const GroundFacts& facts, const Palette& palette, const scene::LandParameters& parameters,
                  base::Seed seed, int side_px) {
    const mesh::Field& height_m = facts.height_m;
    Ground ground{mesh::Image(side_px, side_px, 4), mesh::Image(height_m.columns, height_m.rows, 2)};
    const noise::Key patches(seed.child("patches"));
    const mesh::Field grain = grain_tile(seed);
    const Relief relief(height_m, facts.cell_m);
    const float per_px = static_cast<float>(height_m.columns - 1) / static_cast<float>(side_px);
    const GroundLook look(parameters);
    const float patches_per_px = per_px * facts.cell_m / parameters.ground_patch_m;
    const auto width = static_cast<std::size_t>(side_px);
    std::vector<float> us(width);
    for (std::size_t i = 0; i < width; ++i) us[i] = static_cast<float>(i) * patches_per_px;
    // Each row of samples takes the grain of the row of pixels that begins at it.
    const auto row_of = [&](int y) { return static_cast<int>(std::ceil(static_cast<float>(y) * per_px)); };
    const auto keep_kinds = [&](const Row& r, int y) {
        const int end = y + 1 == side_px ? height_m.rows : std::min(row_of(y + 1), height_m.rows);
        for (int row = row_of(y); row < end; ++row) {
            for (int column = 0; column < height_m.columns; ++column) {
                const auto x = std::min(static_cast<std::size_t>(static_cast<float>(column) / per_px), width - 1);
                ground.kinds.pixel(column, row)[0] = static_cast<std::uint8_t>(255.0F * unit(r.soft[x]) + 0.5F);
                ground.kinds.pixel(column, row)[1] = static_cast<std::uint8_t>(255.0F * unit(r.hard[x]) + 0.5F);
            }
        }
    };
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, side_px, 32), [&](const auto& rows) {
        Row r(width);
        std::fill(r.road_m.begin(), r.road_m.end(), scene::kFarFromRoads_m);
        std::vector<float> vs(width);
        for (int y = rows.begin(); y != rows.end(); ++y) {
            const float row_at = (static_cast<float>(y) + 0.5F) * per_px;
            interpolate(height_m, row_at, per_px, r.height_m);
            interpolate(facts.over_water_m, row_at, per_px, r.shore_m);
            interpolate(relief.slope, row_at, per_px, r.slope);
            interpolate(relief.hollow, row_at, per_px, r.hollow);
            interpolate(relief.shade, row_at, per_px, r.shade);
            interpolate(facts.moisture, row_at, per_px, r.moisture);
            if (!facts.to_road_m.samples.empty()) interpolate(facts.to_road_m, row_at, per_px, r.road_m);
            std::fill(vs.begin(), vs.end(), static_cast<float>(y) * patches_per_px);
            noise::fbm(patches, us, vs, r.patch, {.count = 3, .gain = 0.45F});
            for (std::size_t i = 0; i < width; ++i) {
                r.patch[i] *= 1.6F;
                r.grain[i] = grain.at(static_cast<int>(i % kGrainSide), y % kGrainSide);
            }
            paint(r, palette, look);
            keep_kinds(r, y);
            write_row(r, ground.albedo.pixel(0, y));
        }
    });
    return ground;
}

}  // namespace quadrat::synthesis::land
