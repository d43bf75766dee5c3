// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "render/gpu_scene.hpp"
#include "render/passes/encode.hpp"
#include "render/view.hpp"

namespace quadrat::render {
namespace {

using passes::encode;

constexpr float kLog2E = 1.442695F;
constexpr float kDiscRadius_rad = 0.0105F;  // twice the sun's own: a quarter of a screen is seen from three metres
constexpr float kRippleTurn_rad_s = 1.9F;
constexpr float kGrain = 0.55F;  // of the ground's brightness

// A dimmed view keeps a third of its light: still readable, plainly not chosen.
float kept(float dim) { return 1 - 0.68F * glm::clamp(dim, 0.0F, 1.0F); }

float brightness(glm::vec3 light) { return glm::dot(light, glm::vec3{0.2126F, 0.7152F, 0.0722F}); }

// Means of what a dome shows about 35 degrees up, encoded bytes turned linear by their square.
glm::vec3 high_sky_of(const scene::Sky& sky) {
    glm::vec3 sum{0};
    const int row = sky.dome.height * 55 / 100;
    for (int x = 0; x < sky.dome.width; ++x) {
        const std::uint8_t* pixel = sky.dome.pixel(x, row);
        const glm::vec3 encoded = glm::vec3{pixel[0], pixel[1], pixel[2]} / 255.0F;
        sum += encoded * encoded;
    }
    const glm::vec3 clear = sum / static_cast<float>(std::max(sky.dome.width, 1));
    double density = 0;
    for (const std::uint8_t b : sky.clouds[0].density.bytes) density += b;
    const auto pixels = static_cast<double>(std::max<std::size_t>(sky.clouds[0].density.bytes.size(), 1));
    const float cover = 0.8F * sky.clouds[0].opacity * static_cast<float>(density / (255 * pixels));
    return glm::mix(clear, glm::mix(sky.clouds[0].shaded, sky.clouds[0].sunlit, 0.5F), cover);
}

void set_clouds(passes::ViewBlock& b, const View& view, float left, float seconds) {
    const auto& layers = view.scene->air.clouds;
    const glm::vec3 shaded = encode(layers[0].shaded * left);
    const glm::vec3 gain = encode(layers[0].sunlit * left) - shaded;
    // The upper layer lies on the same scale of light, by its own brightness.
    const float low = brightness(encode(layers[1].shaded * left)) - brightness(shaded);
    const float high = brightness(encode(layers[1].sunlit * left)) - brightness(shaded);
    const float whole = std::max(brightness(gain), 1e-3F);
    b.cloud_shaded = {shaded, (high - low) / whole};
    b.cloud_gain = {gain, low / whole};
    const glm::vec2 eye{view.camera.eye_m.x, view.camera.eye_m.z};
    for (std::size_t i = 0; i < layers.size(); ++i) {
        // Only where in its tile: a large number would lose its fraction.
        const glm::vec2 over = glm::fract((eye - layers[i].wind_m_s * seconds) / layers[i].tile_m);
        b.cloud_place[i] = {over, (layers[i].height_m - view.camera.eye_m.y) / layers[i].tile_m, layers[i].opacity};
    }
}

void set_water(passes::ViewBlock& b, const LightAndAir& air, float left, float seconds) {
    const glm::vec3 shallow = encode(air.shallow_water * left);
    const float cosine = 2 * std::cos(kRippleTurn_rad_s * seconds);
    const float sine = 2 * std::sin(kRippleTurn_rad_s * seconds);
    b.far_colour.w = 0.5F * (cosine + sine);
    b.shallow_water = {shallow, cosine};
    b.deepening = {encode(air.deep_water * left) - shallow, sine};
    b.mirrored = {encode(air.high_sky * left), 0.35F * encode(brightness(air.foam) * left)};
}

}  // namespace

LightAndAir light_and_air_of(const scene::Scene& scene) {
    const scene::Sky& sky = *scene.sky;
    const scene::Land& land = *scene.land;
    LightAndAir a;
    a.to_sun = sky.sun_direction;
    a.sunlight = sky.sunlight;
    a.light_above = sky.light_above;
    a.light_around = sky.light_around;
    a.light_below = sky.light_below;
    a.far_colour = land.far_colour;
    a.haze_colour = sky.haze_colour;
    a.haze_sunward = sky.haze_sunward;
    // Water scatters back what light falls on it from above.
    const glm::vec3 on_water = sky.light_above + sky.sunlight * std::max(sky.sun_direction.y, 0.0F);
    a.shallow_water = land.shallow_colour * on_water;
    a.deep_water = land.deep_colour * on_water;
    a.foam = on_water;
    a.high_sky = high_sky_of(sky);
    a.sun_colour = sky.sun_colour;
    a.haze_distance_m = sky.haze_distance_m;
    a.haze_height_m = sky.haze_height_m;
    a.side_m = land.side_m();
    a.grain_tile_m = land.detail_tile_m;
    for (std::size_t i = 0; i < a.clouds.size(); ++i) {
        const scene::CloudLayer& l = sky.clouds[i];
        a.clouds[i] = {{}, {}, l.tile_m, l.height_m, l.wind_m_s, l.sunlit, l.shaded, l.opacity};
    }
    return a;
}

passes::ViewBlock block_of(const View& view, const glm::mat4& clip_from_world, float seconds) {
    const LightAndAir& air = view.scene->air;
    const float left = kept(view.dim);
    const float root = std::sqrt(2 * left);  // the ground's picture holds the root of half its light
    passes::ViewBlock b;
    b.clip_from_world = clip_from_world;
    b.eye_seconds = {view.camera.eye_m, seconds};
    b.to_sun = {air.to_sun, std::pow(left, 0.45F)};
    b.sunlight = {air.sunlight * left, root};
    b.light_above = {air.light_above * left, 1 / air.side_m};
    b.light_around = {air.light_around * left, 1 / air.grain_tile_m};
    b.light_below = {air.light_below * left, root * 0.5F * kGrain};
    b.far_colour = {air.far_colour, 0};
    b.haze_colour = {encode(air.haze_colour * left), kLog2E / air.haze_distance_m};
    b.haze_sunward = {encode(air.haze_sunward * left), kLog2E / air.haze_height_m};
    b.sun_colour = {encode(air.sun_colour * left), kDiscRadius_rad};
    set_water(b, air, left, seconds);
    set_clouds(b, view, left, seconds);
    return b;
}

float pixels_per_radian(const View& view) {
    const float half = glm::radians(view.camera.vertical_fov_deg) / 2;
    return 0.5F * static_cast<float>(view.viewport.height) / std::tan(half);
}

}  // namespace quadrat::render
