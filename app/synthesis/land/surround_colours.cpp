// SPDX-License-Identifier: Apache-2.0
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/colour.hpp"
#include "synthesis/land/ground.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {
namespace {}  // namespace

namespace {

// The country's covers, in OKLab, and where its snow begins.
struct FarColours {
    glm::vec3 dry, lush, wood, scree, rock, snow;
    float line_m;
};

FarColours far_colours(const Palette& palette, const scene::LandParameters& p) {
    const auto lab = [](const glm::vec3& c) { return scene::oklab_from_linear(c); };
    // Farther off it is warmer air that the heights stand in.
    return {lab(palette.dry),
            lab(palette.lush),
            lab(scene::shifted_colour(palette.lush, 0.74F, 0.85F)),
            lab(palette.scree),
            lab(scene::mix_colours(palette.rock_dark, palette.rock_light, 0.35F)),
            lab(palette.snow),
            std::max(1.6F * snow_line_m(p), snow_line_m(p))};
}

// How a place lies: its height, slope and hollowness, and two noises, for patches and for woods.
struct Lie {
    float h, slope, hollow, n, w;
};

glm::vec3 far_colour(const FarColours& of, const scene::LandParameters& p, const Lie& lie) {
    const auto toward = [](glm::vec3& c, const glm::vec3& to, float t) { c += t * (to - c); };
    glm::vec3 c = of.dry;
    toward(c, of.lush, glm::smoothstep(-0.8F, 0.8F, 0.9F * lie.hollow + 1.4F * lie.n + p.ground_lushness));
    toward(c, of.wood,
           0.85F * glm::smoothstep(-0.05F, 0.18F, lie.w + 0.15F * lie.hollow) *
               (1.0F - glm::smoothstep(0.55F, 0.8F, lie.slope)));
    toward(c, of.scree,
           0.8F * p.ground_scree_fans * glm::smoothstep(0.22F, 0.36F, lie.slope + 0.1F * lie.n) *
               glm::smoothstep(0.0F, 0.5F, lie.hollow + 0.5F * lie.n));
    toward(c, of.scree, 0.8F * glm::smoothstep(0.42F, 0.62F, lie.slope + 0.15F * lie.n));
    // Beds of rock show as bands of light and dark along the slope.
    const float bed = std::sin(lie.h * (3.14159F / std::max(2.0F * p.ground_strata_m, 24.0F)) + 3.0F * lie.n);
    const glm::vec3 banded = of.rock + glm::vec3{0.07F * p.ground_strata * bed, 0, 0};
    toward(c, banded, glm::smoothstep(0.40F, 0.58F, lie.slope + 0.12F * lie.n - 0.1F * lie.hollow));
    const float drift_m = 12.0F + 40.0F * p.ground_snow_wind;
    toward(c, of.snow,
           glm::smoothstep(-6.0F, 8.0F, lie.h - of.line_m + 40.0F * lie.n + drift_m * lie.hollow) *
               (1.0F - glm::smoothstep(0.60F * p.ground_snow_slope, 0.60F * p.ground_snow_slope + 0.12F,
                                       lie.slope + 0.1F * lie.n - 0.12F * lie.hollow)));
    return c;
}

}  // namespace

mesh::Image surround_colours(const mesh::Field& surround_m, float cell_m, const Palette& palette,
                             const scene::LandParameters& p, base::Seed seed) {
    mesh::Image image(surround_m.columns, surround_m.rows, 4);
    const noise::Key woods(seed.child("woods"));
    const noise::Key patches(seed.child("far patches"));
    const FarColours colours = far_colours(palette, p);
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
                const glm::vec3 c = far_colour(colours, p, {h, slope, hollow, n, w});
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
