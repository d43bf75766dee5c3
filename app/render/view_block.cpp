// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "render/gpu_scene.hpp"
#include "render/passes/encode.hpp"
#include "render/passes/ground_brush.hpp"
#include "render/view.hpp"
#include "scene/colour.hpp"
#include "scene/lamps.hpp"
#include "scene/night_eye.hpp"

namespace quadrat::render {
namespace {

using passes::encode;

constexpr float kSnowsBelow_m = 120;   // of the ground that is seen, under the line above which snow lies
constexpr float kSnowier_1_m = 0.12F;  // how much more snow lies on a plant a metre above the snow line
constexpr float kLog2E = 1.442695F;

// A dimmed view keeps a third of its light: still readable, plainly not chosen.
float kept(float dim) { return 1 - 0.68F * glm::clamp(dim, 0.0F, 1.0F); }

// Of a bright cloud's colour no more is shown than fits beside it.
glm::vec3 shown(const glm::vec3& light, float left) { return encode(passes::held(light) * left); }

void set_clouds(choose::ViewBlock& b, const View& view, float left, float seconds) {
    const scene::Sky& sky = view.scene->air.sky;
    const auto& layers = sky.clouds;
    const glm::vec3 shaded = shown(layers[0].shaded, left);
    const glm::vec3 gain = shown(layers[0].sunlit, left) - shaded;
    // The upper layer lies on the same scale of light, by its own brightness.
    const float low = scene::luminance(shown(layers[1].shaded, left)) - scene::luminance(shaded);
    const float high = scene::luminance(shown(layers[1].sunlit, left)) - scene::luminance(shaded);
    const float whole = std::max(scene::luminance(gain), 0.02F);
    b.cloud_shaded = {shaded, (high - low) / whole};
    b.cloud_gain = {gain, low / whole};
    const glm::vec2 eye{view.camera.eye_m.x, view.camera.eye_m.z};
    for (std::size_t i = 0; i < layers.size(); ++i) {
        // Only where in its tile: a large number would lose its fraction.
        const glm::vec2 over = glm::fract(scene::tile_at(layers[i], eye - layers[i].wind_m_s * seconds));
        const float above_m = std::max(layers[i].height_m - view.camera.eye_m.y, 60.0F);
        b.cloud_turn[i] = {scene::tile_at(layers[i], {above_m, 0}), scene::tile_at(layers[i], {0, above_m})};
        b.cloud_place[i] = {over, 0, 0};
    }
    // A cloud takes the sun's share of the light and leaves the sky's.
    const float sun = scene::luminance(sky.sunlight) * std::max(sky.sun_direction.y, 0.0F);
    const float all = sun + scene::luminance(sky.ambient.on({0, 1, 0}));
    b.cloud_place[0].x = scene::cloudscape_drift_rad(layers[0], seconds);
    b.cloud_place[0].z = sky.cloud_shadow * layers[0].opacity * std::min(1.25F * sun / std::max(all, 1e-4F), 1.0F);
    const glm::vec2 run = glm::vec2{sky.sun_direction.x, sky.sun_direction.z} / std::max(sky.sun_direction.y, 0.2F);
    const glm::vec2 over_middle = run * layers[0].height_m - layers[0].wind_m_s * seconds;
    b.shadow_turn = {scene::tile_at(layers[0], {1, 0}), scene::tile_at(layers[0], {0, 1})};
    b.shadow_place = {glm::fract(scene::tile_at(layers[0], over_middle)), scene::tile_at(layers[0], run)};
}

void set_water(choose::ViewBlock& b, const LightAndAir& air, float left) {
    const glm::vec3 shallow = encode(air.shallow_water * left);
    b.shallow_water = {shallow, 0};
    b.deepening = {encode(air.deep_water * left) - shallow, 0};
    b.mirrored = {shown(air.high_sky, left), 0.35F * encode(scene::luminance(air.foam) * left)};
}

}  // namespace

LightAndAir light_and_air_of(const scene::Scene& scene) {
    const scene::Land& land = *scene.land;
    LightAndAir a;
    a.sky = *scene.sky;
    // Moved from, so that their memory goes too.
    a.sky.dome = scene::Dome{};
    a.sky.stars = std::vector<scene::Star>{};
    a.sky.disc.picture = mesh::Image{};
    a.sky.cloudscape = scene::Cloudscape{};
    for (scene::CloudLayer& layer : a.sky.clouds) {
        layer.density = mesh::Image{};
        layer.lit = mesh::Image{};
    }
    // Snow that falls where none lies would be seen to vanish.
    if (a.sky.precipitation.kind == scene::Precipitation::Kind::Snow &&
        land.snow_line_m - scene.floor_m > kSnowsBelow_m)
        a.sky.precipitation.amount = 0;
    // Water scatters back what light falls on it from above.
    const glm::vec3 on_water = a.sky.ambient.on({0, 1, 0}) + a.sky.sunlight * std::max(a.sky.sun_direction.y, 0.0F);
    const float colour_seen = scene::colour_seen(a.sky.darkness);
    a.shallow_water = scene::seen_by_night(land.shallow_colour, colour_seen) * on_water;
    a.deep_water = scene::seen_by_night(land.deep_colour, colour_seen) * on_water;
    a.foam = on_water;
    constexpr int kBearings = 16;
    for (int i = 0; i < kBearings; ++i) {
        const float turn = 6.2831853F * static_cast<float>(i) / kBearings;
        const glm::vec3 toward{0.82F * std::sin(turn), 0.572F, -0.82F * std::cos(turn)};
        a.high_sky += scene::mean_radiance(*scene.sky, toward) / static_cast<float>(kBearings);
    }
    a.exposure = scene.exposure;
    a.floor_m = scene.floor_m;
    a.side_m = land.side_m();
    a.grain_tile_m = land.detail_tile_m;
    a.snow_line_m = land.snow_line_m;
    a.houses_sun = scene.houses_sun;
    a.withered = scene.flora->cover.withered;
    a.lamps = scene::lit_windows(land.settlement, *scene.sky);
    return a;
}

choose::ViewBlock block_of(const View& view, const glm::mat4& clip_from_world, float seconds) {
    const LightAndAir& air = view.scene->air;
    const scene::Sky& sky = air.sky;
    const float left = kept(view.dim) * air.exposure;
    choose::ViewBlock b;
    b.clip_from_world = clip_from_world;
    b.eye_seconds = {view.camera.eye_m, seconds};
    const float kept_shown = std::pow(left, 0.45F);
    b.to_sun = {sky.sun_direction, kept_shown};
    b.to_glow = {sky.glow_direction, sky.silver};
    b.sunlight = {sky.sunlight * left, kept_shown};
    b.ambient = sky.ambient.linear();
    for (glm::vec4& row : b.ambient) row *= left;
    b.scales = {1 / air.side_m, 1 / air.grain_tile_m, 0.5F * passes::kNearGrain, air.lamps};
    b.haze_colour = {shown(sky.haze_colour, left), kLog2E / sky.haze_distance_m};
    b.haze_sunward = {shown(sky.haze_sunward, left), kLog2E / sky.haze_height_m};
    const scene::Mist& mist = sky.mist;
    b.mist = {kLog2E * mist.per_m, air.floor_m + mist.level_m, kLog2E / mist.depth_m,
              7.0F + 0.005F * sky.haze_distance_m};
    // However long a picture is exposed, its sun or moon is not: a moon would be a white disc.
    b.disc = {encode(sky.disc.colour * std::min(left, kept(view.dim))), sky.disc.radius_rad};
    b.glare = {sky.glare * kept_shown, 0.14F * sky.bow * kept_shown};
    const float colour_seen = scene::colour_seen(sky.darkness);
    b.eye_snow = {colour_seen, 1 - colour_seen, air.snow_line_m, kSnowier_1_m};
    set_water(b, air, left);
    set_clouds(b, view, left, seconds);
    b.cloud_place[0].y = air.withered;
    b.cloud_place[1].z = air.houses_sun;
    b.cloud_place[1].w = std::pow(kept(view.dim), 0.45F);
    return b;
}

float aspect_ratio(const View& view) {
    return static_cast<float>(view.viewport.width) / static_cast<float>(std::max(view.viewport.height, 1));
}

glm::mat3 clip_from_direction(const glm::mat4& clip_from_world) {
    glm::mat3 m;
    for (int column = 0; column < 3; ++column)
        m[column] = {clip_from_world[column].x, clip_from_world[column].y, clip_from_world[column].w};
    return m;
}

glm::mat4 strip_of(glm::mat4 clip_from_world, glm::vec2 between) {
    for (int column = 0; column < 4; ++column) {
        glm::vec4& c = clip_from_world[column];
        c.x = (2 * c.x - (between.x + between.y) * c.w) / (between.y - between.x);
    }
    return clip_from_world;
}

glm::mat4 clip_from_world_of(const View& view) {
    return scene::clip_from_view(view.camera, aspect_ratio(view)) * scene::view_from_world(view.camera);
}

float pixels_per_radian(const View& view) {
    const float half = glm::radians(view.camera.vertical_fov_deg) / 2;
    return 0.5F * static_cast<float>(view.viewport.height) / std::tan(half);
}

}  // namespace quadrat::render
