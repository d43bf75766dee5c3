// SPDX-License-Identifier: Apache-2.0
#include "render/held_sky.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <span>

#include "render/gpu_scene.hpp"
#include "render/view.hpp"

namespace quadrat::render {
namespace {

constexpr float kWider = 1.06F;      // than the view, in what of the picture plane it sees
constexpr float kFineness = 0.45F;   // pixels a pixel of the view, a side
constexpr float kMostShear = 0.03F;  // of the clouds' height: two degrees overhead
constexpr float kMostDimmed = 0.1F;  // cloud, air and dome do not dim by quite the same factor

// Whether the lower clouds hide more than the upper ones.
bool is_led_by_lower(const GpuScene& scene) {
    const auto& layers = scene.air.sky.clouds;
    const auto cover = [](const scene::CloudLayer& layer) { return layer.opacity * layer.mean_density; };
    return cover(layers[1]) <= cover(layers[0]);
}

// From where the lower clouds are seen now to where they were seen then: they turn about the eye.
glm::mat3 turn_back(float drifted_rad, float then_rad) {
    const float turned = drifted_rad - then_rad;
    const float sine = std::sin(turned);
    const float cosine = std::cos(turned);
    return {{cosine, 0, -sine}, {0, 1, 0}, {sine, 0, cosine}};
}

// The same for a flat layer: what is over the eye at height 1.
glm::mat3 drift(const scene::CloudLayer& layer, const glm::vec4& eye_seconds, const glm::vec4& then) {
    const auto above_m = [&](const glm::vec4& eye) { return std::max(layer.height_m - eye.y, 60.0F); };
    const glm::vec2 wind = layer.wind_m_s * (eye_seconds.w - then.w);
    const glm::vec2 moved{eye_seconds.x - then.x - wind.x, eye_seconds.z - then.z - wind.y};
    const float nearer = above_m(eye_seconds) / above_m(then);
    glm::mat3 shear{1};
    shear[0].x = shear[2].z = nearer;
    shear[1] = {moved.x / above_m(then), 1, moved.y / above_m(then)};
    return shear;
}

glm::ivec2 picture_size(const Rect& viewport) {
    return glm::max(glm::ivec2(glm::ceil(glm::vec2{viewport.width, viewport.height} * (kWider * kFineness))), 1);
}

glm::ivec2 size_of(const gl::Texture2D& picture) {
    return picture.name() == 0 ? glm::ivec2{0} : glm::ivec2{picture.shape().width, picture.shape().height};
}

gl::Texture2D flat_picture(glm::ivec2 size) {
    return gl::Texture2D{{.width = size.x, .height = size.y, .sampling = gl::Sampling::Flat}};
}

}  // namespace

const float kSkyDrawnAnew = kWider * kWider * kFineness * kFineness / HeldSky::kFrames;

std::optional<glm::mat3> HeldSky::from_view(const View& view, const choose::ViewBlock& now) const {
    if (held_.scene.lock() != view.scene || held_.viewport != view.viewport ||
        held_.fov_deg != view.camera.vertical_fov_deg)
        return std::nullopt;
    const bool is_lower = is_led_by_lower(*view.scene);
    const glm::mat3 shear = is_lower ? turn_back(now.cloud_place[0].x, held_.block.cloud_place[0].x)
                                     : drift(view.scene->air.sky.clouds[1], now.eye_seconds, held_.block.eye_seconds);
    for (const float moved : {shear[1].x, shear[1].z, shear[0].x - 1, shear[2].x})
        if (std::abs(moved) > kMostShear) return std::nullopt;
    if (std::abs(kept(now) - 1) > kMostDimmed) return std::nullopt;
    const glm::mat3 half{{0.5F, 0, 0}, {0, 0.5F, 0}, {0.5F, 0.5F, 1}};
    const glm::mat3 m = half * clip_from_direction(held_.block.clip_from_world) * shear *
                        glm::inverse(clip_from_direction(now.clip_from_world));
    constexpr std::array<glm::vec2, 4> kCorners{glm::vec2{-1, -1}, glm::vec2{1, -1}, glm::vec2{-1, 1}, glm::vec2{1, 1}};
    const bool covers = std::ranges::all_of(kCorners, [&](glm::vec2 corner) {
        const glm::vec3 at = m * glm::vec3{corner, 1};
        const glm::vec2 over = glm::vec2{at} / at.z;
        return at.z > 0 && over.x >= 0 && over.x <= 1 && over.y >= 0 && over.y <= 1;
    });
    return covers ? std::optional(m) : std::nullopt;
}

gl::Work HeldSky::Canvas::draw(const View& view, float seconds, const passes::SkyPass& sky) {
    const glm::ivec2 size = picture_size(view.viewport);
    if (size_of(picture_) != size) picture_ = flat_picture(size);
    glm::mat4 clip_from_world = clip_from_world_of(view);
    for (int column = 0; column < 4; ++column) {
        clip_from_world[column].x /= kWider;
        clip_from_world[column].y /= kWider;
    }
    drawn_ = {view.scene, view.viewport, view.camera.vertical_fov_deg, block_of(view, clip_from_world, seconds)};
    block_.fill<std::byte>(std::as_bytes(std::span(&drawn_.block, 1)));
    const auto drawing = target_.onto(picture_);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);  // a tiler need not fetch what was there
    gl::bind_uniforms(block_, choose::kViewBinding, 0, sizeof(choose::ViewBlock));
    return sky.draw_dome(*view.scene->sky, choose::Frustum(clip_from_world), view.camera.eye_m);
}

void HeldSky::take(const Canvas& canvas) {
    const glm::ivec2 size = size_of(canvas.picture_);
    if (size_of(picture_) != size) picture_ = flat_picture(size);
    canvas.target_.copy(canvas.picture_, picture_);
    held_ = canvas.drawn_;
}

}  // namespace quadrat::render
