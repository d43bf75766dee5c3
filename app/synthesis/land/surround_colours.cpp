// SPDX-License-Identifier: Apache-2.0
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/colour.hpp"
#include "scene/land_parameters.hpp"
#include "synthesis/land/ground.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {
namespace {

constexpr float kEased_m = 320.0F;  // over which the country around takes up the land's own colours

// The land's mean colour about a place on it, linear.
glm::vec3 mean_about(const mesh::Image& albedo, glm::vec2 at_px, int reach_px) {
    glm::vec3 sum{0};
    float count = 0;
    const auto middle = [](float at, int side) { return std::clamp(static_cast<int>(at), 0, side - 1); };
    const int x = middle(at_px.x, albedo.width);
    const int y = middle(at_px.y, albedo.height);
    const int stride = std::max(1, reach_px / 8);
    for (int r = std::max(0, y - reach_px); r <= std::min(albedo.height - 1, y + reach_px); r += stride) {
        for (int c = std::max(0, x - reach_px); c <= std::min(albedo.width - 1, x + reach_px); c += stride) {
            const std::uint8_t* pixel = albedo.pixel(c, r);
            for (int k = 0; k < 3; ++k) sum[k] += scene::linear_from_srgb(static_cast<float>(pixel[k]) / 255.0F);
            count += 1;
        }
    }
    return sum / std::max(count, 1.0F);
}

// What a colour hangs on.
struct Place {
    float height_m;
    float over_snow_line_m;
    float slope;   // rise over run
    float hollow;  // more than 0 in hollows, less than 0 on crests
    float patch;   // about -1 to 1
};

// In OKLab.
struct Bare {
    glm::vec3 scree, rock, snow;
};

void toward(glm::vec3& colour, const glm::vec3& to, float share) { colour += share * (to - colour); }

// Scree, rock and snow over whatever grows.
void lay_bare(glm::vec3& c, const Place& at, const Bare& bare, const scene::LandParameters& p) {
    const float n = at.patch;
    toward(c, bare.scree,
           0.8F * p.ground_scree_fans * glm::smoothstep(0.22F, 0.36F, at.slope + 0.1F * n) *
               glm::smoothstep(0.0F, 0.5F, at.hollow + 0.5F * n));
    toward(c, bare.scree, 0.8F * glm::smoothstep(0.42F, 0.62F, at.slope + 0.15F * n));
    // Beds of rock show as bands of light and dark along the slope.
    const float bed = std::sin(at.height_m * (3.14159F / std::max(2.0F * p.ground_strata_m, 24.0F)) + 3.0F * n);
    const glm::vec3 banded = bare.rock + glm::vec3{0.07F * p.ground_strata * bed, 0, 0};
    toward(c, banded, glm::smoothstep(0.40F, 0.58F, at.slope + 0.12F * n - 0.1F * at.hollow));
    const float drift_m = 12.0F + 40.0F * p.ground_snow_wind;
    const float steepest = 0.60F * p.ground_snow_slope;
    toward(c, bare.snow,
           glm::smoothstep(-6.0F, 8.0F, at.over_snow_line_m + 40.0F * n + drift_m * at.hollow) *
               (1.0F - glm::smoothstep(steepest, steepest + 0.12F, at.slope + 0.1F * n - 0.12F * at.hollow)));
}

}  // namespace

void ease_into_land(mesh::Image& surround, float cell_m, const mesh::Image& albedo, float side_m) {
    const float half = 0.5F * static_cast<float>(surround.width - 1);
    const float half_m = 0.5F * side_m;
    const float px_per_m = static_cast<float>(albedo.width) / side_m;
    for (int row = 0; row < surround.height; ++row) {
        for (int column = 0; column < surround.width; ++column) {
            const glm::vec2 at_m =
                cell_m * glm::vec2{static_cast<float>(column) - half, static_cast<float>(row) - half};
            const glm::vec2 on_land_m = glm::clamp(at_m, glm::vec2{-half_m}, glm::vec2{half_m});
            const float out_m = std::max(std::abs(at_m.x), std::abs(at_m.y)) - half_m;
            if (out_m >= kEased_m || out_m < -1.5F * cell_m) continue;
            const float t = std::clamp(out_m / kEased_m, 0.0F, 1.0F);
            const float share = t * t * (3.0F - 2.0F * t);
            std::uint8_t* pixel = surround.pixel(column, row);
            glm::vec3 own{0};
            for (int k = 0; k < 3; ++k) own[k] = scene::linear_from_srgb(static_cast<float>(pixel[k]) / 255.0F);
            const glm::vec3 land =
                mean_about(albedo, (on_land_m + half_m) * px_per_m, static_cast<int>(0.5F * cell_m * px_per_m));
            const glm::vec3 mixed = scene::mix_colours(land, own, share);
            for (int k = 0; k < 3; ++k) pixel[k] = scene::srgb_byte(mixed[k]);
        }
    }
}

mesh::Image surround_colours(const mesh::Field& surround_m, float cell_m, const Palette& palette,
                             const scene::LandParameters& p, base::Seed seed) {
    mesh::Image image(surround_m.columns, surround_m.rows, 4);
    const noise::Key woods(seed.child("woods"));
    const noise::Key patches(seed.child("far patches"));
    const auto lab = [](const glm::vec3& c) { return scene::oklab_from_linear(c); };
    const glm::vec3 dry = lab(palette.dry);
    const glm::vec3 lush = lab(palette.lush);
    const glm::vec3 wood = lab(scene::shifted_colour(palette.lush, 0.74F, 0.85F));
    const glm::vec3 scree = lab(palette.scree);
    const glm::vec3 rock = lab(scene::mix_colours(palette.rock_dark, palette.rock_light, 0.35F));
    const glm::vec3 snow = lab(palette.snow);
    // Farther off it is warmer air that the heights stand in.
    const float line_m = std::max(1.6F * snow_line_m(p), snow_line_m(p));
    const int last = surround_m.columns - 1;
    const auto width = static_cast<std::size_t>(surround_m.columns);
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, surround_m.rows, 16), [&](const auto& rows) {
        std::vector<float> us(width);
        std::vector<float> vs(width);
        std::vector<float> woody(width);
        std::vector<float> patch(width);
        for (int row = rows.begin(); row != rows.end(); ++row) {
            for (std::size_t i = 0; i < width; ++i) us[i] = static_cast<float>(i) * cell_m / 520.0F;
            std::fill(vs.begin(), vs.end(), static_cast<float>(row) * cell_m / 520.0F);
            noise::fbm(woods, us, vs, woody, {.count = 3, .gain = 0.6F});
            noise::fbm(patches, us, vs, patch, {.count = 2, .gain = 0.5F});
            for (int column = 0; column <= last; ++column) {
                const auto at = [&](int c, int r) {
                    return surround_m.at(std::clamp(c, 0, last), std::clamp(r, 0, surround_m.rows - 1));
                };
                const float h = surround_m.at(column, row);
                const float dx = at(column + 1, row) - at(column - 1, row);
                const float dz = at(column, row + 1) - at(column, row - 1);
                const float slope = std::sqrt(dx * dx + dz * dz) / (2.0F * cell_m);
                const float around =
                    0.25F * (at(column - 1, row) + at(column + 1, row) + at(column, row - 1) + at(column, row + 1));
                const float hollow = std::clamp((around - h) / 14.0F, -1.0F, 1.0F);
                const float n = patch[static_cast<std::size_t>(column)];
                const float w = woody[static_cast<std::size_t>(column)];
                glm::vec3 c = dry;
                toward(c, lush, glm::smoothstep(-0.8F, 0.8F, 0.9F * hollow + 1.4F * n + p.ground_lushness));
                toward(c, wood,
                       0.85F * glm::smoothstep(-0.05F, 0.18F, w + 0.15F * hollow) *
                           (1.0F - glm::smoothstep(0.55F, 0.8F, slope)));
                lay_bare(c, {h, h - line_m, slope, hollow, n}, {scree, rock, snow}, p);
                const glm::vec3 linear = scene::linear_from_oklab(c);
                for (int k = 0; k < 3; ++k)
                    image.pixel(column, row)[k] = scene::srgb_byte(std::clamp(linear[k], 0.0F, 1.0F));
                image.pixel(column, row)[3] = 255;
            }
        }
    });
    return image;
}

}  // namespace quadrat::synthesis::land
