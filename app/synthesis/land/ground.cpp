// SPDX-License-Identifier: Apache-2.0
#include "synthesis/land/ground.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "scene/colour.hpp"
#include "synthesis/noise/gradient.hpp"

namespace quadrat::synthesis::land {
namespace {

float smooth(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

// The palette in OKLab, so that a pixel is one weighted sum and one way back.
struct LabPalette {
    glm::vec3 lush, dry, heath, soil, scree, rock_light, rock_dark, sand, snow;

    explicit LabPalette(const Palette& p)
        : lush(scene::oklab_from_linear(p.lush)),
          dry(scene::oklab_from_linear(p.dry)),
          heath(scene::oklab_from_linear(p.heath)),
          soil(scene::oklab_from_linear(p.soil)),
          scree(scene::oklab_from_linear(p.scree)),
          rock_light(scene::oklab_from_linear(p.rock_light)),
          rock_dark(scene::oklab_from_linear(p.rock_dark)),
          sand(scene::oklab_from_linear(p.sand)),
          snow(scene::oklab_from_linear(p.snow)) {}
};

struct Place {
    float height_m;
    float slope;   // rise over run
    float hollow;  // more than 0 in hollows, less than 0 on ridges
    float patch;   // quiet large patches, -1 to 1
    float grain;   // fine variation, -1 to 1
};

glm::vec3 mix(const glm::vec3& a, const glm::vec3& b, float t) { return a + (b - a) * t; }

glm::vec3 ground_colour_lab(const LabPalette& lab, const Place& place, float snow_line_m) {
    const float wander = 0.5F * place.patch + 0.35F * place.grain;
    glm::vec3 c = mix(lab.dry, lab.lush, smooth(-0.9F, 0.9F, 1.5F * place.hollow + 0.9F * place.patch));
    c = mix(c, lab.heath, 0.75F * smooth(0.25F, 0.7F, place.patch * -1.0F + 0.3F * place.grain));
    c = mix(c, lab.soil, smooth(0.42F, 0.66F, place.slope + 0.16F * wander));
    c = mix(c, lab.scree, smooth(0.58F, 0.80F, place.slope + 0.12F * wander));
    const float strata = std::sin(place.height_m * 0.42F + 3.0F * place.patch + 0.8F * place.grain);
    const glm::vec3 rock = mix(lab.rock_dark, lab.rock_light, 0.5F + 0.5F * strata);
    c = mix(c, rock, smooth(0.74F, 1.05F, place.slope + 0.10F * wander));
    const float beach_top_m = 1.6F + 1.2F * place.patch;
    const float beach =
        (1.0F - smooth(beach_top_m, beach_top_m + 1.4F, place.height_m)) * (1.0F - smooth(0.5F, 0.8F, place.slope));
    c = mix(c, lab.sand, beach);
    const float snow = smooth(snow_line_m - 10.0F, snow_line_m + 16.0F, place.height_m + 14.0F * wander) *
                       (1.0F - smooth(0.75F, 1.1F, place.slope));
    c = mix(c, lab.snow, snow);
    c.x *= 1.0F + 0.035F * place.grain;
    return c;
}

}  // namespace

mesh::Image ground_albedo(const mesh::Field& height_m, float cell_m, const Palette& palette, float snow_line_m,
                          base::Seed seed, int side_px) {
    mesh::Image image(side_px, side_px, 4);
    const LabPalette lab(palette);
    const noise::Key patches(seed.child("patches"));
    const noise::Key grains(seed.child("grain"));
    const float samples_per_px = static_cast<float>(height_m.columns - 1) / static_cast<float>(side_px);
    const float px_m = samples_per_px * cell_m;
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, side_px, 16), [&](const auto& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y) {
            const float row = (static_cast<float>(y) + 0.5F) * samples_per_px;
            for (int x = 0; x < side_px; ++x) {
                const float column = (static_cast<float>(x) + 0.5F) * samples_per_px;
                const float h = mesh::sample(height_m, column, row);
                const float west = mesh::sample(height_m, column - 1, row);
                const float east = mesh::sample(height_m, column + 1, row);
                const float north = mesh::sample(height_m, column, row - 1);
                const float south = mesh::sample(height_m, column, row + 1);
                const float wide =
                    0.25F * (mesh::sample(height_m, column - 9, row) + mesh::sample(height_m, column + 9, row) +
                             mesh::sample(height_m, column, row - 9) + mesh::sample(height_m, column, row + 9));
                const float run_m = 2.0F * cell_m;
                const float dx = (east - west) / run_m;
                const float dz = (south - north) / run_m;
                const float x_m = static_cast<float>(x) * px_m;
                const float z_m = static_cast<float>(y) * px_m;
                const Place place{h, std::sqrt(dx * dx + dz * dz), std::clamp((wide - h) / 3.5F, -1.0F, 1.0F),
                                  1.6F * noise::fbm(patches, x_m / 70.0F, z_m / 70.0F, {.count = 3, .gain = 0.45F}),
                                  1.6F * noise::fbm(grains, x_m / 6.0F, z_m / 6.0F, {.count = 2, .gain = 0.5F})};
                const glm::vec3 c = scene::linear_from_oklab(ground_colour_lab(lab, place, snow_line_m));
                std::uint8_t* pixel = image.pixel(x, y);
                pixel[0] = scene::srgb_byte(c.x);
                pixel[1] = scene::srgb_byte(c.y);
                pixel[2] = scene::srgb_byte(c.z);
                pixel[3] = static_cast<std::uint8_t>(255.0F * (1.0F - smooth(0.15F, 0.9F, h)));
            }
        }
    });
    return image;
}

mesh::Image ground_detail(base::Seed seed, int side_px) {
    mesh::Image image(side_px, side_px, 1);
    const noise::Key blades(seed.child("detail"));
    const noise::Key tufts(seed.child("tufts"));
    for (int y = 0; y < side_px; ++y) {
        for (int x = 0; x < side_px; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(side_px);
            const float v = static_cast<float>(y) / static_cast<float>(side_px);
            const float n = noise::fbm_tiled(tufts, 6 * u, 6 * v, 6, {.count = 3, .gain = 0.6F}) +
                            0.7F * noise::fbm_tiled(blades, 24 * u, 24 * v, 24, {.count = 2, .gain = 0.7F});
            image.pixel(x, y)[0] = static_cast<std::uint8_t>(std::clamp(128.0F + 70.0F * n, 0.0F, 255.0F));
        }
    }
    return image;
}

}  // namespace quadrat::synthesis::land
