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
#include "scene/land_parameters.hpp"
#include "synthesis/land/erosion.hpp"
#include "synthesis/land/ground_row.hpp"
#include "synthesis/land/patterns.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr int kGrainSide = 256;  // pixels of the repeating fine variation
constexpr int kTussocks = 84;    // of it, from side to side

// The kernels for the processor at hand.
struct Kernels {
    void (*paint)(const GroundRow&, const GroundLook&) = &GroundKernel<xsimd::default_arch>::paint;
    decltype(&interpolate_ground_row) interpolate = &interpolate_ground_row;
};

Kernels kernels_here() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") != 0) return {&paint_ground_row_avx2, &interpolate_ground_row_avx2};
#endif
    return {};
}

Material material(const glm::vec3& linear, float soft, float hard) {
    const glm::vec3 lab = scene::oklab_from_linear(linear);
    return {lab.x, lab.y, lab.z, soft, hard};
}

Material mixed(const Material& one, const Material& other, float share) {
    const auto mix = [share](float a, float b) { return a + share * (b - a); };
    return {mix(one.l, other.l), mix(one.a, other.a), mix(one.b, other.b), mix(one.soft, other.soft),
            mix(one.hard, other.hard)};
}

// Dunes are sand where other land is dry grass, earth or scree; it bears nothing.
void cover_with_sand(GroundLook& look, const Palette& palette, float share) {
    constexpr float kGrain = 0.30F;
    const Material sand = material(palette.sand, kGrain, 0);
    for (Material* m : {&look.dry, &look.soil, &look.scree}) {
        Material own = sand;
        own.l += 0.25F * (m->l - own.l);  // crests and flanks are told apart
        *m = mixed(*m, own, share);
    }
}

// Beside snow rock is dark, or neither would be seen for the other.
void darken_beside_snow(GroundLook& look, const scene::LandParameters& p) {
    constexpr float kPalest = 0.85F;  // in OKLab
    const float snowy = std::clamp(1.4F - snow_line_m(p) / std::max(p.land_relief_m, 1.0F), 0.0F, 1.0F);
    for (Material* m : {&look.rock_dark, &look.rock_light, &look.scree}) {
        const float dark = 1.35F * kPalest * m->l / (kPalest + m->l);
        m->l += snowy * std::min(dark - m->l, 0.0F);
    }
}

GroundLook look_of(const scene::LandParameters& p, const Palette& palette) {
    GroundLook look;
    look.dry = material(palette.dry, 1, 0);
    look.lush = material(palette.lush, 1, 0);
    look.heath = material(palette.heath, 1, 0);
    look.soil = material(palette.soil, 0.7F, 0.1F);
    look.scree = material(palette.scree, 0.2F, 0.7F);
    look.rock_dark = material(palette.rock_dark, 0, 1);
    look.rock_light = material(palette.rock_light, 0, 1);
    look.mud = material(scene::shifted_colour(palette.soil, 0.72F, 0.8F), 0.6F, 0.25F);
    look.sand = material(palette.sand, 0.25F, 0.35F);
    look.gravel = material(scene::mix_colours(palette.sand, palette.scree, 0.5F), 0.3F, 0.35F);
    look.snow = material(palette.snow, 0.2F, 0.1F);
    cover_with_sand(look, palette, sandy(p));
    darken_beside_snow(look, p);
    look.lushness = 1.1F * p.ground_lushness - 0.35F * p.ground_moisture;
    look.thirst = 2.0F * p.ground_moisture;
    look.heath_share = p.ground_heath;
    look.soil_slope = p.ground_soil_slope;
    look.scree_slope = p.ground_scree_slope;
    look.rock_slope = p.ground_rock_slope;
    look.beds_per_m = 2.0F / p.ground_strata_m;
    look.contrast = 0.5F * p.ground_strata;
    look.mud_share = 0.7F * std::clamp(p.marsh_share, 0.0F, 1.0F) + 0.25F;
    // Marsh is green to the water's edge.
    const float sandy = p.ground_beach * (1.0F - 0.85F * std::clamp(p.marsh_share, 0.0F, 1.0F));
    look.beach_top_m = 0.05F + sandy * std::clamp(0.014F * p.land_relief_m, 0.25F, 1.6F);
    // Far above everything where no snow lies.
    look.snow_line_m = snow_line_m(p);
    look.snow_broken = p.ground_snow_patchiness;
    look.snow_aspect_m = 26.0F * p.ground_snow_aspect;
    look.snow_slope = p.ground_snow_slope;
    look.snow_drift_m = 22.0F * p.ground_snow_wind;
    look.fans = 0.9F * p.ground_scree_fans;
    look.grain = 0.11F * p.ground_grain;
    look.wet_top_m = p.ground_wet_shore_m;
    return look;
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

constexpr float kGrainLost = 6;  // of the grain, where the ground rises as far as it runs: all but a seventh

mesh::Field grain_tile(base::Seed seed) {
    mesh::Field tile(kGrainSide, kGrainSide);
    const noise::Key key(seed.child("grain"));
    std::vector<float> us(kGrainSide);
    for (int x = 0; x < kGrainSide; ++x) us[x] = kTussocks * static_cast<float>(x) / kGrainSide;
    for (int y = 0; y < kGrainSide; ++y) {
        const std::vector<float> vs(kGrainSide, us[y]);
        noise::fbm_tiled(key, us, vs, std::span(tile.samples).subspan(tile.index(0, y), us.size()), kTussocks,
                         {.count = 2, .gain = 0.7F});
    }
    for (float& g : tile.samples) g *= 1.6F;
    return tile;
}

// The pixels of a picture over a field's samples: where between them each lies.
class PixelPlaces {
  public:
    PixelPlaces(int samples, int side_px)
        : per_px_(static_cast<float>(samples - 1) / static_cast<float>(side_px)), samples_(samples) {
        for (int i = 0; i < side_px; ++i) {
            const float x = (static_cast<float>(i) + 0.5F) * per_px_;
            first_.push_back(std::min(static_cast<int>(x), samples - 2));
            share_.push_back(x - static_cast<float>(first_.back()));
        }
    }
    float per_px() const { return per_px_; }
    // One row of pixels from a field, bilinear. between: room for a row of samples.
    void interpolate(const mesh::Field& field, int row_px, std::vector<float>& between, std::vector<float>& out) const {
        static const Kernels kernels = kernels_here();
        const float* above = field.samples.data() + field.index(0, first_[static_cast<std::size_t>(row_px)]);
        kernels.interpolate(above, above + field.columns, share_[static_cast<std::size_t>(row_px)], samples_,
                            first_.data(), share_.data(), static_cast<int>(share_.size()), between.data(), out.data());
    }

  private:
    float per_px_;
    int samples_;
    std::vector<std::int32_t> first_;
    std::vector<float> share_;
};

// Room for one row of pixels.
struct RowRoom {
    explicit RowRoom(std::size_t pixels, std::size_t samples) : between(samples), pixels_(pixels) {
        const std::size_t width = (pixels + kMostLanes - 1) / kMostLanes * kMostLanes;
        for (auto* values : {&height_m, &shore_m, &slope, &hollow, &moisture, &shade, &patch, &grain, &red, &green,
                             &blue, &wet, &soft, &hard})
            values->resize(width);
        road_m.assign(width, scene::kFarFromRoads_m);
    }
    GroundRow row() {
        return {static_cast<int>(pixels_),
                height_m.data(),
                shore_m.data(),
                slope.data(),
                hollow.data(),
                moisture.data(),
                shade.data(),
                road_m.data(),
                patch.data(),
                grain.data(),
                red.data(),
                green.data(),
                blue.data(),
                wet.data(),
                soft.data(),
                hard.data()};
    }

    std::vector<float> between, height_m, shore_m, slope, hollow, moisture, shade, road_m, patch, grain, red, green,
        blue, wet, soft, hard;
    std::size_t pixels() const { return pixels_; }

  private:
    std::size_t pixels_;
};

void write_row(const RowRoom& r, std::uint8_t* pixel) {
    const auto& bytes = scene::srgb_bytes_by_root();
    for (std::size_t i = 0; i < r.pixels(); ++i, pixel += 4) {
        pixel[0] = bytes[static_cast<std::size_t>(static_cast<int>(r.red[i]))];
        pixel[1] = bytes[static_cast<std::size_t>(static_cast<int>(r.green[i]))];
        pixel[2] = bytes[static_cast<std::size_t>(static_cast<int>(r.blue[i]))];
        pixel[3] = static_cast<std::uint8_t>(r.wet[i]);
    }
}

// Each row of samples takes the grain of the row of pixels it lies in.
void write_kinds(const RowRoom& r, float per_px, int row_px, int side_px, mesh::Image& kinds) {
    const auto sample_row = [per_px](int y) { return static_cast<int>(std::ceil(static_cast<float>(y) * per_px)); };
    const int end = row_px + 1 == side_px ? kinds.height : std::min(sample_row(row_px + 1), kinds.height);
    for (int row = sample_row(row_px); row < end; ++row) {
        for (int column = 0; column < kinds.width; ++column) {
            const auto x = std::min(static_cast<std::size_t>(static_cast<float>(column) / per_px), r.pixels() - 1);
            kinds.pixel(column, row)[0] = static_cast<std::uint8_t>(r.soft[x]);
            kinds.pixel(column, row)[1] = static_cast<std::uint8_t>(r.hard[x]);
        }
    }
}

// Bands of bare ground across what grows. They are laid as if the ground were as steep as where earth begins to show.
class Bands {
  public:
    Bands(const scene::LandParameters& p, base::Seed seed, float px_m)
        : share_(std::clamp(p.ground_bands, 0.0F, 1.0F)),
          bare_slope_(p.ground_soil_slope + 0.17F),
          samples_per_px_(px_m / kBandsTile_m) {
        if (share_ > 0) bare_ = bare_bands(seed.child("bands"));
        samples_per_px_ *= static_cast<float>(bare_.columns);
    }

    void lay(int row_px, RowRoom& r) const {
        if (share_ <= 0) return;
        const auto side = static_cast<float>(bare_.columns);
        const float v = std::fmod((static_cast<float>(row_px) + 0.5F) * samples_per_px_, side);
        for (std::size_t x = 0; x < r.pixels(); ++x) {
            // Not along the water, and drawn out by what winds the patches.
            const float dry = std::clamp((r.shore_m[x] - 2.0F) / 4.0F, 0.0F, 1.0F);
            if (dry <= 0) continue;
            const float u = (static_cast<float>(x) + 0.5F) * samples_per_px_ + 5.0F * r.patch[x];
            const float bare = tiled_sample(std::fmod(u + side, side), v);
            const float strong = std::min(share_ * (1.3F + 0.8F * r.patch[x]), 1.0F) * dry;
            r.slope[x] = std::max(r.slope[x], strong * bare * bare_slope_);
            r.moisture[x] = std::min(r.moisture[x] + 0.35F * strong * (1 - bare), 1.0F);
        }
    }

  private:
    float tiled_sample(float u, float v) const {
        const int x = static_cast<int>(u) % bare_.columns;
        const int y = static_cast<int>(v) % bare_.rows;
        const int right = (x + 1) % bare_.columns;
        const int below = (y + 1) % bare_.rows;
        const float s = u - std::floor(u);
        const float t = v - std::floor(v);
        return (1 - t) * ((1 - s) * bare_.at(x, y) + s * bare_.at(right, y)) +
               t * ((1 - s) * bare_.at(x, below) + s * bare_.at(right, below));
    }
    float share_;
    float bare_slope_;
    float samples_per_px_;
    mesh::Field bare_;
};

// Flats that have dried lie bare in patches. As with bands, they are laid as if they were steep.
class DryFlats {
  public:
    explicit DryFlats(const scene::LandParameters& p)
        : share_(0.9F * cracked(p)), bare_slope_(p.ground_soil_slope + 0.2F) {}

    void lay(RowRoom& r) const {
        if (share_ <= 0) return;
        for (std::size_t x = 0; x < r.pixels(); ++x) {
            const float flat = 1 - std::clamp((r.slope[x] - 0.1F) / 0.2F, 0.0F, 1.0F);
            const float patch = std::clamp(0.5F + 2.2F * r.patch[x] + 2.0F * (share_ - 0.5F), 0.0F, 1.0F);
            r.slope[x] = std::max(r.slope[x], share_ * flat * patch * bare_slope_);
        }
    }

  private:
    float share_;
    float bare_slope_;
};

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
    const PixelPlaces places(height_m.columns, side_px);
    const GroundLook look = look_of(parameters, palette);
    const DryFlats flats(parameters);
    const Bands bands(parameters, seed, places.per_px() * facts.cell_m);
    const float patches_per_px = places.per_px() * facts.cell_m / parameters.ground_patch_m;
    const auto width = static_cast<std::size_t>(side_px);
    std::vector<float> us(width);
    for (std::size_t i = 0; i < width; ++i) us[i] = static_cast<float>(i) * patches_per_px;
    static const Kernels kernels = kernels_here();
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, side_px, 32), [&](const auto& rows) {
        RowRoom r(width, static_cast<std::size_t>(height_m.columns));
        std::vector<float> vs(width);
        for (int y = rows.begin(); y != rows.end(); ++y) {
            const auto interpolate = [&](const mesh::Field& field, std::vector<float>& out) {
                places.interpolate(field, y, r.between, out);
            };
            interpolate(height_m, r.height_m);
            interpolate(facts.over_water_m, r.shore_m);
            interpolate(relief.slope, r.slope);
            interpolate(relief.hollow, r.hollow);
            interpolate(relief.shade, r.shade);
            interpolate(facts.moisture, r.moisture);
            if (!facts.to_road_m.samples.empty()) interpolate(facts.to_road_m, r.road_m);
            std::fill(vs.begin(), vs.end(), static_cast<float>(y) * patches_per_px);
            noise::fbm(patches, us, vs, std::span(r.patch).first(width), {.count = 3, .gain = 0.45F});
            for (float& p : r.patch) p *= 1.6F;
            bands.lay(y, r);
            flats.lay(r);
            const float* grains = &grain.at(0, y % kGrainSide);
            // It is painted as seen from above: the steeper the ground, the longer its tufts would be drawn down it.
            for (std::size_t i = 0; i < width; ++i)
                r.grain[i] = grains[i % kGrainSide] / (1 + kGrainLost * r.slope[i] * r.slope[i]);
            kernels.paint(r.row(), look);
            write_row(r, ground.albedo.pixel(0, y));
            write_kinds(r, places.per_px(), y, side_px, ground.kinds);
        }
    });
    return ground;
}

float cracked(const scene::LandParameters& p) {
    const float dry = std::clamp((0.5F - p.ground_lushness) / 0.6F, 0.0F, 1.0F);
    return dry * std::clamp(p.ground_cracks, 0.0F, 1.0F);
}

float sandy(const scene::LandParameters& p) {
    const float t = std::clamp((p.dune_share - 0.35F) / 0.4F, 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

// From the shore upward; on low land there is snow in cold country only.
float snow_line_m(const scene::LandParameters& p) {
    const float over_shore = p.ground_snow_line - p.land_sea_level - 0.15F;
    if (p.land_relief_m < 140.0F && over_shore > 0.3F) return 1.0e6F;
    return 2.0F + 1.15F * over_shore * p.land_relief_m * (1.0F - p.land_sea_level);
}

}  // namespace quadrat::synthesis::land
