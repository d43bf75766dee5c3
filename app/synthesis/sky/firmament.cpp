// SPDX-License-Identifier: Apache-2.0
#include "synthesis/sky/firmament.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/colour.hpp"
#include "synthesis/sky/clouds.hpp"
#include "synthesis/sky/daylight.hpp"

namespace quadrat::synthesis::sky {
namespace {

constexpr int kDomeWidth = 512;
constexpr int kDomeHeight = 160;
constexpr float kDomeSpan_deg = 100.0F;  // from the zenith to 10 degrees under the horizon

glm::vec3 direction_of(float azimuth_deg, float altitude_deg) {
    const float a = glm::radians(azimuth_deg);
    const float h = glm::radians(altitude_deg);
    return {std::cos(h) * std::sin(a), std::sin(h), -std::cos(h) * std::cos(a)};
}

// Half a step of noise hides the bands that eight bits would show in so slow a gradient.
std::uint8_t dithered(float linear, std::uint64_t hash) {
    const float step = 255.0F * scene::srgb_from_linear(linear) + base::unit_of(hash);
    return static_cast<std::uint8_t>(std::clamp(step, 0.0F, 255.0F));
}

mesh::Image dome_image(const Daylight& daylight) {
    mesh::Image dome(kDomeWidth, kDomeHeight, 4);
    for (int y = 0; y < kDomeHeight; ++y) {
        const float altitude = 90.0F - kDomeSpan_deg * (static_cast<float>(y) + 0.5F) / static_cast<float>(kDomeHeight);
        for (int x = 0; x < kDomeWidth; ++x) {
            const float azimuth = 360.0F * (static_cast<float>(x) + 0.5F) / static_cast<float>(kDomeWidth);
            const glm::vec3 c = daylight.radiance(direction_of(azimuth, altitude));
            const std::uint64_t hash = base::hash_of(base::Seed{17}, x, y);
            std::uint8_t* pixel = dome.pixel(x, y);
            pixel[0] = dithered(c.x, hash);
            pixel[1] = dithered(c.y, hash << 13U);
            pixel[2] = dithered(c.z, hash << 26U);
            pixel[3] = 255;
        }
    }
    return dome;
}

glm::vec3 mean_radiance(const Daylight& daylight, float altitude_deg) {
    constexpr int kDirections = 16;
    glm::vec3 sum{0};
    for (int i = 0; i < kDirections; ++i)
        sum += daylight.radiance(direction_of(360.0F * static_cast<float>(i) / kDirections, altitude_deg));
    return sum / static_cast<float>(kDirections);
}

glm::vec3 tinted(const glm::vec3& colour, float warmth) {
    const glm::vec3 rose{1.42F, 0.90F, 0.78F};
    const glm::vec3 blue{0.66F, 0.95F, 1.38F};
    return colour * (glm::vec3{1} + ((warmth > 0 ? rose : blue) - glm::vec3{1}) * std::abs(warmth));
}

void light_from_sky(scene::Sky& sky, const Daylight& daylight, const scene::SkyParameters& p) {
    const glm::vec3 high = 0.5F * (mean_radiance(daylight, 75) + mean_radiance(daylight, 45));
    const glm::vec3 low = 0.5F * (mean_radiance(daylight, 22) + mean_radiance(daylight, 6));
    sky.light_above = tinted(high, p.ambient_warmth) * (p.ambient_strength * (0.80F + 0.18F * daylight.lowness()));
    sky.light_around = tinted(low, p.ambient_warmth) * (p.ambient_strength * (0.52F + 0.10F * daylight.lowness()));
    const glm::vec3 ground{0.20F, 0.18F, 0.13F};
    sky.light_below = ground * (sky.sunlight * (0.35F + 0.65F * sky.sun_direction.y) + sky.light_above);
}

void paint_layer(scene::CloudLayer& layer, CloudImages images, const Daylight& daylight, const scene::Sky& sky) {
    layer.density = std::move(images.density);
    layer.lit = std::move(images.lit);
    const float low = daylight.lowness();
    layer.sunlit =
        glm::vec3{0.62F - 0.16F * low} * sky.sunlight + 0.34F * sky.light_above + 0.10F * low * daylight.sun_colour();
    layer.sunlit = layer.sunlit / (0.72F + 0.30F * layer.sunlit);
    layer.shaded = 0.55F * sky.light_above + 0.35F * sky.light_around + glm::vec3{0.06F} * sky.sunlight;
}

}  // namespace

scene::Sky make_sky(const scene::SkyParameters& p, base::Seed seed) {
    scene::Sky sky;
    const Daylight daylight(p);
    sky.sun_direction = daylight.sun_direction();
    sky.sunlight = daylight.sunlight();
    sky.sun_colour = daylight.sun_colour();
    sky.dome = dome_image(daylight);
    light_from_sky(sky, daylight, p);

    sky.haze_distance_m = p.haze_distance_m;
    sky.haze_height_m = 260.0F + 0.12F * p.haze_distance_m;
    sky.haze_sunward = daylight.radiance(direction_of(p.sun_azimuth_deg, 1.5F));
    sky.haze_colour = 0.5F * (daylight.radiance(direction_of(p.sun_azimuth_deg + 90.0F, 1.5F)) +
                              daylight.radiance(direction_of(p.sun_azimuth_deg - 90.0F, 1.5F)));

    base::RandomStream random{seed.child("weather")};
    const float cover = random.between(0.30F, 0.60F);
    const float veil = random.between(0.30F, 0.55F);
    const float bearing = random.between(-3.14159F, 3.14159F);
    const float speed_m_s = random.between(4.0F, 11.0F);

    CloudShape lower{.side_px = 512, .masses = 3, .octaves = 6, .cover = cover, .sharpness = p.cloud_sharpness};
    paint_layer(sky.clouds[0], make_clouds(lower, sky.sun_direction, seed.child("lower clouds")), daylight, sky);
    sky.clouds[0].tile_m = 3.0F * p.cloud_scale_m;
    sky.clouds[0].height_m = 620.0F + 0.22F * p.cloud_scale_m;
    sky.clouds[0].wind_m_s = speed_m_s * glm::vec2{std::cos(bearing), std::sin(bearing)};
    sky.clouds[0].opacity = 0.94F;

    CloudShape upper{.side_px = 256, .masses = 2, .octaves = 6, .cover = veil, .sharpness = 0.35F * p.cloud_sharpness};
    paint_layer(sky.clouds[1], make_clouds(upper, sky.sun_direction, seed.child("upper clouds")), daylight, sky);
    sky.clouds[1].tile_m = 4.5F * p.cloud_scale_m;
    sky.clouds[1].height_m = 2600.0F;
    sky.clouds[1].wind_m_s = 1.6F * sky.clouds[0].wind_m_s;
    sky.clouds[1].opacity = 0.55F;
    return sky;
}

}  // namespace quadrat::synthesis::sky
