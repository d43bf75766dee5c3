// SPDX-License-Identifier: Apache-2.0
#include "synthesis/sky/firmament.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "scene/colour.hpp"
#include "scene/sky_parameters.hpp"
#include "synthesis/sky/clouds.hpp"
#include "synthesis/sky/cloudscape.hpp"
#include "synthesis/sky/daylight.hpp"
#include "synthesis/sky/night.hpp"

namespace quadrat::synthesis::sky {
namespace {

using Parameters = scene::SkyParameters;

glm::vec2 way(float bearing_deg) {
    const float a = glm::radians(bearing_deg);
    return {std::sin(a), -std::cos(a)};
}

// Rain or snow; 0 to 1.
struct Falling {
    float rain;
    float snow;
    float any() const { return std::max(rain, snow); }
};

Falling falling(const Parameters& p) { return {std::max(p.rain_share, 0.0F), std::max(p.snowfall_share, 0.0F)}; }

// Where flights are, about, above the sea.
constexpr float kEye_m = 25.0F;

// Clouds that leave a gap are seen to end, also from under a shower; snow hides that.
float gap_of(const Parameters& p) { return p.cloud_gap * (1.0F - std::min(falling(p).snow, 1.0F)); }

// A low sun shines in under clouds that end far off: 0 to 1.
float under_clouds(const Parameters& p, const Lights& lights) {
    const float gap = gap_of(p);
    return gap > 0.1F ? 1.0F - closed_over_gap(gap, 0.7F * lights.brightest().y) : 0.0F;
}

// Never burnt out: the shoulder of a film, by luminance.
glm::vec3 held(const glm::vec3& c, float most) {
    const float y = scene::luminance(c);
    return y > 0 ? c * (most * (1.0F - std::exp(-y / most)) / y) : c;
}

glm::vec3 of_clouds(const glm::vec3& c, float warmth) {
    const glm::vec3 tint = glm::mix(
        glm::vec3{1}, warmth > 0 ? glm::vec3{1.26F, 0.93F, 0.90F} : glm::vec3{0.72F, 0.98F, 1.22F}, std::abs(warmth));
    return c * tint;
}

void paint_layer(scene::CloudLayer& layer, CloudImages images, const Parameters& p, const Daylight& day,
                 const Lights& lights, float depth) {
    layer.density = std::move(images.density);
    layer.lit = std::move(images.lit);
    layer.mean_density = images.mean_density;
    layer.mean_lit = images.mean_lit;
    const glm::vec3 sky = glm::mix(day.sky_light, glm::vec3{scene::luminance(day.sky_light)}, 0.55F);
    const float closed = overcast(p);
    const glm::vec3 sun = day.high_light * (0.95F + 0.40F * lights.lowness);
    const glm::vec3 sunlit = sun * (1.0F - 0.55F * closed) + 0.75F * sky;
    const glm::vec3 through = glm::mix(sun, glm::vec3{scene::luminance(sun)}, 0.6F);
    const glm::vec3 shaded = (0.78F * sky + 0.22F * through) * (0.86F - 0.50F * depth) * (1.0F - 0.45F * closed);
    layer.sunlit = held(of_clouds(sunlit, 0.8F * p.cloud_warmth), 1.5F);
    layer.shaded = held(of_clouds(shaded, p.cloud_warmth), 0.9F);
}

glm::vec3 in_the_tile(const glm::vec3& sun, const glm::vec2& along) {
    const glm::vec2 flat{sun.x, sun.z};
    return {glm::dot(flat, glm::vec2{-along.y, along.x}), sun.y, glm::dot(flat, along)};
}

// Flights look north: heaps are lit as if the light stood a little farther toward the eye's side than it does, so that
// it models them.
glm::vec3 heap_light(const glm::vec3& sun) {
    const float flat = std::max(std::hypot(sun.x, sun.z), 0.05F);
    const glm::vec3 lit{0.8F * sun.x / flat, 0, 0.8F * sun.z / flat + 0.45F};
    const float length = std::max(std::hypot(lit.x, lit.z), 0.05F);
    return {lit.x * flat / length, sun.y, lit.z * flat / length};
}

constexpr glm::ivec2 kCloudscape{1280, 240};

// Of its base's height: what stood taller would be seen as a wall overhead.
constexpr float kTallest = 0.75F;

// The lower clouds as they stand over the land. depth: of the layer, over its tile.
scene::Cloudscape stand_up(const scene::CloudLayer& low, const mesh::Field& depth, const Parameters& p,
                           const glm::vec3& sun, const glm::vec3& brightest, base::Seed seed) {
    const float tall_m = 0.5F * p.cloud_scale_m * p.cloud_tower * (0.35F + 0.65F * p.cloud_thickness);
    const CloudscapeShape shape{depth,
                                low.tile_m,
                                low.stretch,
                                low.along,
                                std::max(low.height_m - kEye_m, 120.0F),
                                std::clamp(tall_m, 60.0F, kTallest * low.height_m),
                                gap_of(p),
                                p.sun_beams,
                                std::max(p.sun_halo, 0.0F),
                                heap_light(sun),
                                brightest,
                                seed.child("bulges")};
    return make_cloudscape(shape, kCloudscape.x, kCloudscape.y);
}

// As opaque as they are as a flat layer, which casts their shadow.
void set_low(scene::CloudLayer& low, const Parameters& p) {
    low.tile_m = 3.0F * p.cloud_scale_m;
    low.stretch = p.cloud_stretch;
    low.along = way(p.cloud_wind_deg);
    low.height_m = p.cloud_height_m;
    low.wind_m_s = p.cloud_wind_m_s * low.along;
    low.opacity = 0.80F + 0.18F * p.cloud_thickness;
}

void add_clouds(scene::Sky& sky, const Parameters& p, const Daylight& day, const Lights& lights, base::Seed seed) {
    const glm::vec3 sun = lights.is_night && lights.sun_height_deg < -6.0F ? lights.moon : lights.sun;
    const glm::vec2 wind = p.cloud_wind_m_s * way(p.cloud_wind_deg);
    scene::CloudLayer& low = sky.clouds[0];
    set_low(low, p);
    const CloudShape heaps{512,
                           3,
                           6,
                           p.cloud_roughness,
                           p.cloud_billow,
                           p.cloud_clumps,
                           p.cloud_cover,
                           p.cloud_sharpness,
                           p.cloud_thickness};
    const mesh::Field depth = cloud_depth(heaps, seed.child("lower clouds"));
    paint_layer(low, light_clouds(depth, heaps, in_the_tile(heap_light(sun), low.along)), p, day, lights,
                p.cloud_thickness * (0.55F + 0.45F * overcast(p)));
    low.lit = mesh::Image();  // as they are seen, they are lit
    sky.cloudscape = stand_up(low, depth, p, sun, lights.brightest(), seed);
    scene::CloudLayer& high = sky.clouds[1];
    high.tile_m = 2.0F * p.cirrus_scale_m / std::sqrt(p.cirrus_stretch);
    high.stretch = p.cirrus_stretch;
    high.along = way(p.cirrus_bearing_deg);
    high.height_m = p.cloud_height_m + 2600.0F;
    high.wind_m_s = 1.6F * wind;
    high.opacity = 0.25F + 0.5F * p.cirrus_sharpness;
    const CloudShape feathers{
        256, 2, 6, 0.58F, -0.3F * p.cirrus_sharpness, 0.4F, 0.92F * p.cirrus_cover, 0.45F * p.cirrus_sharpness, 0.25F};
    paint_layer(high, make_clouds(feathers, in_the_tile(sun, high.along), seed.child("upper clouds")), p, day, lights,
                0.1F);
    sky.silver = p.cloud_silver;
    sky.cloud_shadow = p.cloud_shadow * (1.0F - overcast(p));
}

// Under closed clouds no clear horizon is left but where they end far off: the dome itself turns to their grey.
void close_dome(scene::Dome& dome, const scene::CloudLayer& clouds, float closed, float gap) {
    const glm::vec3 grey = glm::mix(clouds.shaded, clouds.sunlit, 0.55F * clouds.mean_lit + 0.25F);
    for (int row = 0; row < scene::Dome::kRows; ++row) {
        // Moon & Spencer 1942: an overcast zenith is three times as bright as its horizon. Half of that here.
        const float height = scene::Dome::direction(0, row).y;
        const float up = 0.8F + 0.4F * height;
        const float here = closed * (gap > 0 ? closed_over_gap(gap, height) : 1.0F);
        for (int column = 0; column < scene::Dome::kColumns; ++column)
            dome.at(column, row) = glm::mix(dome.at(column, row), grey * up, 0.92F * here);
    }
}

void set_air(scene::Sky& sky, const Parameters& p, const Lights& lights) {
    const Falling falls = falling(p);
    sky.haze_distance_m = std::max(p.haze_distance_m / (1.0F + 1.2F * falls.rain + 1.8F * falls.snow), 380.0F);
    sky.haze_height_m = p.haze_height_m * (1.15F - 0.75F * p.haze_pool) + 300.0F * falls.any();
    const auto low = [&](float aside_deg) {
        const float bearing = glm::degrees(std::atan2(sky.glow_direction.x, -sky.glow_direction.z)) + aside_deg;
        const glm::vec2 flat = way(bearing);
        return sky.dome.radiance(glm::normalize(glm::vec3{flat.x, 0.035F, flat.y}));
    };
    const glm::vec3 across = 0.5F * (low(90) + low(-90)) + 0.05F * sky.sunlight;
    // The air is lit by what lies behind it and by all the sky.
    const glm::vec3 even = glm::mix(across, sky.ambient.on({0, 1, 0}), 0.25F);
    const float night_glow = lights.is_night ? 0.6F * (1.0F - lights.darkness) + 0.15F : 1.0F;
    sky.haze_sunward = held(glm::mix(even, low(0), p.haze_sunward * night_glow * 0.75F), 0.80F);
    sky.haze_colour = held(even, 0.72F);
    // Thick air has scattered its light so often that it is nearly white.
    const float thick = std::clamp(p.mist_share, 0.0F, 1.0F);
    sky.haze_sunward = glm::mix(sky.haze_sunward, glm::vec3{scene::luminance(sky.haze_sunward)}, 0.35F * thick);
    if (p.mist_share <= 0) return;
    // By night the same mist is as light as what is lit, and leaves nothing dark.
    const float by_night = lights.is_night ? 0.4F : 1.0F;
    sky.mist = {by_night * 0.0028F * std::pow(4.5F, p.mist_share), p.mist_level_m, p.mist_depth_m};
    const glm::vec3 tint = p.mist_warmth > 0 ? glm::vec3{1.18F, 0.98F, 0.76F} : glm::vec3{0.80F, 0.97F, 1.20F};
    const glm::vec3 mixed = glm::mix(glm::vec3{1}, tint, 0.8F * std::abs(p.mist_warmth));
    sky.haze_colour *= mixed;
    sky.haze_sunward *= mixed;
}

// Calls with directions of even pieces of the sphere, above the horizon or below, and a piece's solid angle.
template <typename Piece>
void for_half_sphere(bool is_above, const Piece& piece) {
    constexpr int kBands = 24;
    constexpr int kSectors = 32;
    constexpr float kPi = std::numbers::pi_v<float>;
    for (int band = 0; band < kBands; ++band) {
        const float y = (static_cast<float>(band) + 0.5F) / kBands;
        const float flat = std::sqrt(1.0F - y * y);
        for (int sector = 0; sector < kSectors; ++sector) {
            const float turn = 2.0F * kPi * (static_cast<float>(sector) + 0.5F) / kSectors;
            piece(glm::vec3{flat * std::sin(turn), is_above ? y : -y, -flat * std::cos(turn)},
                  2.0F * kPi / (kBands * kSectors));
        }
    }
}

void gather_ambient(scene::Sky& sky, const Parameters& p, const Lights& lights) {
    // By night the eye opens the shadows; no light that could be seen does.
    const glm::vec3 opened = glm::mix(glm::vec3{0.9F}, glm::vec3{0.55F, 0.85F, 1.5F}, p.night_blue) *
                             ((0.09F + 0.10F * p.ambient_strength) * lights.darkness);
    glm::vec3 level{0};
    for_half_sphere(true, [&](const glm::vec3& d, float sr) {
        const glm::vec3 seen = scene::mean_radiance(sky, d) + opened;
        sky.ambient.add(d, seen, sr);
        level += seen * (d.y * sr / std::numbers::pi_v<float>);
    });
    const glm::vec3 earth = glm::vec3{0.21F, 0.18F, 0.13F} * (0.5F + 2.2F * p.air_ground);
    const glm::vec3 on_ground = level + sky.sunlight * std::max(sky.sun_direction.y, 0.1F);
    sky.light_below = p.light_bounce * earth * on_ground;
    for_half_sphere(false, [&](const glm::vec3& d, float sr) { sky.ambient.add(d, sky.light_below, sr); });
    sky.ambient.correct_level(level);
}

// A drop falls at its own speed whatever the wind; strokes that lie flatter than some 30 degrees from upright read as
// scratches on the picture.
glm::vec3 rain_speed_m_s(glm::vec2 wind, float slant) {
    constexpr float kFalls = 9.5F;
    constexpr float kMost = 0.55F * kFalls;
    const glm::vec2 drift = (0.25F + 1.1F * slant) * wind;
    const float speed = glm::length(drift);
    const float held = speed > 0 ? kMost * std::tanh(speed / kMost) / speed : 0;
    return {held * drift.x, -kFalls, held * drift.y};
}

void add_falling(scene::Sky& sky, const Parameters& p) {
    const Falling falls = falling(p);
    if (falls.any() <= 0) return;
    scene::Precipitation& f = sky.precipitation;
    const glm::vec2 wind = p.cloud_wind_m_s * way(p.cloud_wind_deg);
    const glm::vec3 light = sky.ambient.on({0, 1, 0}) + 0.3F * sky.sunlight;
    f.amount = 0.25F + 0.75F * falls.any();
    if (falls.rain > 0) {
        f.kind = scene::Precipitation::Kind::Rain;
        f.speed_m_s = rain_speed_m_s(wind, p.rain_slant);
        f.width_m = 0.003F;
        f.streak_s = 0.012F + 0.005F * falls.rain;
        f.opacity = 0.26F + 0.2F * falls.rain;
        f.colour = held(1.15F * light, 1.0F);
    } else {
        f.kind = scene::Precipitation::Kind::Snow;
        f.speed_m_s = {0.32F * wind.x, -1.25F, 0.32F * wind.y};
        f.width_m = 0.021F * p.snowfall_flake;
        f.opacity = 0.85F;
        f.colour = held(1.5F * light + glm::vec3{0.05F}, 1.1F);
    }
}

// Rain that falls here, or far off from clouds enough for a shower: drops that a bow can stand in. Snow makes none.
float showers(const Parameters& p) {
    const Falling falls = falling(p);
    if (falls.snow > 0) return 0;
    return falls.rain > 0 ? 1 : glm::smoothstep(0.2F, 0.45F, p.cloud_cover);
}

// What lies before it hides it: mist, thick air.
float bow_of(const Parameters& p, float closed) {
    return std::max(p.bow_strength, 0.0F) * showers(p) * (1.0F - 0.7F * closed) *
           (1.0F - std::clamp(1.3F * p.mist_share, 0.0F, 1.0F)) * glm::smoothstep(350.0F, 1600.0F, p.haze_distance_m);
}

void add_disc(scene::Sky& sky, const Parameters& p, const Lights& lights, base::Seed seed) {
    const float open = 1.0F - overcast(p);
    sky.disc.radius_rad = 0.0105F * p.sun_size;
    if (lights.is_night) {
        sky.disc.picture = moon_picture(128, p.moon_phase, seed.child("moon"));
        sky.disc.radius_rad *= 1.7F;
        sky.disc.colour =
            glm::mix(glm::vec3{0.95F, 0.96F, 1.0F}, glm::vec3{1.0F, 0.78F, 0.5F}, std::max(p.moon_warmth, 0.0F));
        sky.glare = sky.disc.colour * (0.13F * p.sun_glow * p.moon_phase * open);
        return;
    }
    sky.disc.picture = sun_picture(64);
    const glm::vec3 sun = sky.sunlight / std::max({sky.sunlight.x, sky.sunlight.y, sky.sunlight.z, 1.0e-4F});
    sky.disc.colour = glm::mix(sun, glm::vec3{1}, 0.35F) * 1.3F;
    sky.glare = sun * (0.55F * p.sun_glow * open * (0.6F + 0.05F * p.air_turbidity));
}

}  // namespace

scene::Sky make_sky(const scene::SkyParameters& p, base::Seed seed) {
    scene::Sky sky;
    const Lights lights(p);
    Daylight day = make_daylight(p, lights);
    sky.is_night = lights.is_night;
    sky.darkness = lights.is_night ? lights.darkness : 0;
    sky.sun_direction = lights.brightest();
    // After nightfall the sky glows where the sun went, until the moon is all there is.
    sky.glow_direction = lights.is_night && lights.darkness > 0.75F ? lights.moon : lights.sun;
    sky.dome = day.dome;
    add_clouds(sky, p, day, lights, seed);
    const float closed = overcast(p);
    close_dome(sky.dome, sky.clouds[0], std::min(1.35F * closed, 1.0F), gap_of(p));
    sky.sunlight = day.sunlight * (1.0F - 0.82F * closed * (1.0F - 0.7F * under_clouds(p, lights))) *
                   (1.0F - 0.15F * falling(p).any());
    gather_ambient(sky, p, lights);
    set_air(sky, p, lights);
    add_disc(sky, p, lights, seed);
    add_falling(sky, p);
    if (lights.is_night) sky.stars = make_stars(p, lights.darkness * (1.0F - 0.8F * closed), seed);
    // Its middle is 42 degrees from the point opposite the sun: with a higher sun it lies under the horizon.
    if (!lights.is_night && lights.sun_height_deg < 41.0F) sky.bow = bow_of(p, closed);
    sky.shadow_softness = p.light_softness;
    sky.bounce = p.light_bounce;
    sky.occlusion = p.light_occlusion;
    return sky;
}

}  // namespace quadrat::synthesis::sky
