// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "render/gpu_scene.hpp"
#include "render/view.hpp"

namespace quadrat::render {
namespace {

constexpr float kLog2E = 1.442695F;
constexpr float kDiscRadius_rad = 0.0105F;  // twice the sun's own: a quarter of a screen is seen from three metres
constexpr float kRippleTurn_rad_s = 1.9F;
constexpr float kGrain = 0.55F;

// A dimmed view keeps a third of its light: still readable, plainly not chosen.
float kept(float dim) { return 1 - 0.68F * glm::clamp(dim, 0.0F, 1.0F); }

glm::vec4 times(const glm::vec4& colour_and_more, float factor) {
    return {glm::vec3{colour_and_more} * factor, colour_and_more.w};
}

}  // namespace

passes::ViewBlock colours_of(const scene::Scene& scene) {
    const scene::Sky& sky = *scene.sky;
    const scene::Land& land = *scene.land;
    passes::ViewBlock b;
    b.to_sun = {sky.sun_direction, 0.5F * land.side_m()};
    b.sunlight = {sky.sunlight, 1};
    b.light_above = {sky.light_above, 1 / land.side_m()};
    b.light_around = {sky.light_around, 1 / land.detail_tile_m};
    b.light_below = {sky.light_below, kGrain};
    b.haze_colour = {sky.haze_colour, kLog2E / sky.haze_distance_m};
    b.haze_sunward = {sky.haze_sunward, kLog2E / sky.haze_height_m};
    b.far_colour = {land.far_colour, 0};
    // Water scatters back what light falls on it from above.
    const glm::vec3 on_water = sky.light_above + sky.sunlight * glm::max(sky.sun_direction.y, 0.0F);
    b.shallow_colour = {land.shallow_colour * on_water, 0};
    b.deep_colour = {land.deep_colour * on_water, 0};
    b.sun_colour = {sky.sun_colour, std::cos(kDiscRadius_rad)};
    for (std::size_t i = 0; i < sky.clouds.size(); ++i) {
        b.cloud_sunlit[i] = {sky.clouds[i].sunlit, 0};
        b.cloud_shaded[i] = {sky.clouds[i].shaded, 0};
    }
    return b;
}

passes::ViewBlock block_of(const View& view, const glm::mat4& clip_from_world, float seconds) {
    passes::ViewBlock b = view.scene->colours;
    b.clip_from_world = clip_from_world;
    b.eye_seconds = {view.camera.eye_m, seconds};
    const float left = kept(view.dim);
    b.sunlight = {glm::vec3{b.sunlight} * left, left};
    for (glm::vec4* colour : {&b.light_above, &b.light_around, &b.light_below, &b.haze_colour, &b.haze_sunward,
                              &b.shallow_colour, &b.deep_colour, &b.sun_colour, &b.cloud_sunlit[0], &b.cloud_sunlit[1],
                              &b.cloud_shaded[0], &b.cloud_shaded[1]})
        *colour = times(*colour, left);
    b.shallow_colour.w = std::cos(kRippleTurn_rad_s * seconds);
    b.deep_colour.w = std::sin(kRippleTurn_rad_s * seconds);
    for (std::size_t i = 0; i < b.cloud_place.size(); ++i) {
        const scene::CloudLayer& layer = view.scene->cloud_layers[i];
        const glm::vec2 eye{view.camera.eye_m.x, view.camera.eye_m.z};
        // Only where in its tile: a large number would lose its fraction.
        const glm::vec2 over = glm::fract((eye - layer.wind_m_s * seconds) / layer.tile_m);
        b.cloud_place[i] = {over, (layer.height_m - view.camera.eye_m.y) / layer.tile_m, layer.opacity};
    }
    return b;
}

float pixels_per_radian(const View& view) {
    const float half = glm::radians(view.camera.vertical_fov_deg) / 2;
    return 0.5F * static_cast<float>(view.viewport.height) / std::tan(half);
}

}  // namespace quadrat::render
