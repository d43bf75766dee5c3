// SPDX-License-Identifier: Apache-2.0
#include "render/held_distance.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "render/gpu_scene.hpp"
#include "render/view.hpp"

namespace quadrat::render {
namespace {

constexpr float kWider = 1.03F;       // than the view, in what of the picture plane it sees
constexpr float kNearest_m = 30;      // of a split
constexpr float kFarthest_m = 400;    // beyond it is little that could be held
constexpr float kMostDimmed = 0.1F;   // what is near does not dim by quite the same factor
constexpr float kMostSeconds = 1.5F;  // between two frames time has jumped
constexpr float kMostStep_m = 3;      // between two frames the view was cut
constexpr float kLonger = 1.15F;      // a way is than it would be at the speed of now
constexpr float kStill_m = 0.01F;     // as much is moved at least

View widened(View view) {
    view.viewport = {0, 0, static_cast<int>(std::lround(kWider * static_cast<float>(view.viewport.width))),
                     static_cast<int>(std::lround(kWider * static_cast<float>(view.viewport.height)))};
    const float half = std::atan(kWider * std::tan(glm::radians(view.camera.vertical_fov_deg) / 2));
    view.camera.vertical_fov_deg = 2 * glm::degrees(half);
    return view;
}

glm::ivec2 picture_size(const View& wide, float scale) {
    const glm::vec2 size{wide.viewport.width, wide.viewport.height};
    return glm::max(glm::ivec2(glm::round(size * scale)), 1);
}

glm::vec2 on_map(const glm::vec3& at_m) { return {at_m.x, at_m.z}; }

bool covers(const passes::DistanceWarp& warp) {
    constexpr std::array<glm::vec2, 4> kCorners{glm::vec2{-1, -1}, glm::vec2{1, -1}, glm::vec2{-1, 1}, glm::vec2{1, 1}};
    return std::ranges::all_of(kCorners, [&](glm::vec2 corner) {
        const glm::vec3 held = HeldDistance::over_held(warp, corner);
        const glm::vec2 over = glm::vec2{held} / held.z;
        return held.z > 0 && over.x >= 0 && over.x <= 1 && over.y >= 0 && over.y <= 1;
    });
}

// What lies so many metres deep has this depth, plus that over its metres, in the depth buffer.
glm::vec2 depth_terms(const glm::mat4& clip_from_world, const glm::vec3& eye_m) {
    const auto row = [&](int i) {
        return glm::vec4{clip_from_world[0][i], clip_from_world[1][i], clip_from_world[2][i], clip_from_world[3][i]};
    };
    const glm::vec3 ahead{row(3)};
    return {glm::dot(glm::vec3{row(2)}, ahead), glm::dot(row(2), glm::vec4{eye_m, 1})};
}

bool can_hold(const View& view) { return view.growth >= 1 && !view.scene->country->land.land.roam; }

}  // namespace

const float kDistanceDrawnAnew = kWider * kWider / HeldDistances::kFrames;

// What is held lies on a sphere: where a way from the eye meets it, as a way from where it was drawn.
glm::vec3 HeldDistance::over_held(const passes::DistanceWarp& warp, glm::vec2 clip) {
    const glm::vec3 unit = glm::normalize(warp.way_from_clip * glm::vec3{clip, 1});
    const glm::vec3 moved{warp.moved_radius};
    const float along = glm::dot(unit, moved);
    const float radius = warp.moved_radius.w;
    const float reach = std::sqrt(along * along + radius * radius - glm::dot(moved, moved)) - along;
    return warp.held_from_way * (moved + unit * reach);
}

passes::DistanceWarp HeldDistance::warp(const Sight& sight, const glm::mat4& clip_from_world, const glm::vec3& eye_m) {
    const glm::vec2 depth = depth_terms(clip_from_world, eye_m);
    passes::DistanceWarp warp;
    warp.way_from_clip = glm::inverse(clip_from_direction(clip_from_world));
    warp.held_from_way = sight.picture_from_way;
    warp.moved_radius = {eye_m - sight.eye_m, 2 * sight.split_m};
    warp.split = {sight.split_m, depth.x, depth.y};
    return warp;
}

std::optional<passes::DistanceWarp> HeldDistance::from_view(const View& view, const choose::ViewBlock& now,
                                                            float scale) const {
    if (!can_hold(view) || sight_.scene.lock() != view.scene || sight_.viewport != view.viewport ||
        sight_.fov_deg != view.camera.vertical_fov_deg || picture_.name() == 0)
        return std::nullopt;
    if (std::abs(now.eye_seconds.w - sight_.seconds) > kMostSeconds) return std::nullopt;
    const float kept = now.to_sun.w / sight_.light;
    if (std::abs(kept - 1) > kMostDimmed) return std::nullopt;
    const float moved_m = glm::distance(view.camera.eye_m, sight_.eye_m);
    if (off_px(moved_m, sight_.split_m, scale * pixels_per_radian(view)) > kMost_px) return std::nullopt;
    passes::DistanceWarp there = warp(sight_, now.clip_from_world, view.camera.eye_m);
    there.kept = {kept, 1};
    if (!covers(there)) return std::nullopt;
    return there;
}

choose::Reach HeldDistance::near() const { return {choose::Reach::Part::Near, on_map(sight_.eye_m), sight_.split_m}; }

std::optional<HeldDistances::Turn> HeldDistances::turn_of(std::size_t frame, std::size_t views) {
    const std::size_t strips = std::max(kFrames / std::max<std::size_t>(views, 1), std::size_t{1});
    const std::size_t turn = frame % kFrames;
    if (turn / strips >= views) return std::nullopt;
    return Turn{turn / strips, turn % strips, strips};
}

void HeldDistances::drop() {
    held_.clear();
    glides_.clear();
    stocks_.clear();
    drawing_.reset();
    is_drawn_ = false;
    view_ = {};
    sight_ = {};
    canvas_.let_go();
    smooth_.let_go();
}

void HeldDistances::follow(const View& view, Glide& glide) const {
    const glm::vec3 step_m = view.camera.eye_m - glide.camera.eye_m;
    glide.is_known = glide.scene.lock() == view.scene && glm::length(step_m) < kMostStep_m;
    glide.eye_step_m = step_m;
    glide.target_step_m = view.camera.target_m - glide.camera.target_m;
    glide.scene = view.scene;
    glide.camera = view.camera;
}

void HeldDistances::take() {
    if (!is_drawn_ || !drawing_) return;
    HeldDistance& held = held_[*drawing_];
    const gl::TextureShape& shape = canvas_.picture().shape();
    if (!(held.picture_.name() != 0 && held.picture_.shape() == shape)) held.picture_ = gl::Texture2D{shape};
    // Software rasterisers finish all that was drawn so far before they read a texture that was ever a target.
    copying_.copy(canvas_.picture(), held.picture_);
    held.sight_ = std::move(sight_);
    drawing_.reset();
    is_drawn_ = false;
}

void HeldDistances::serve(const Frame& frame, const std::vector<HeldSky>& skies, std::vector<Selection>& selections) {
    ++frames_;
    const std::size_t views = frame.views.size();
    if (held_.size() != views) {
        drop();
        held_.resize(views);
        glides_.resize(views);
        while (stocks_.size() < views) stocks_.push_back(std::make_unique<Stock>());
    }
    take();
    for (std::size_t slot = 0; slot < views; ++slot) {
        follow(frame.views[slot], glides_[slot]);
        serve_one(frame, skies, slot, selections[slot]);
    }
}

void HeldDistances::serve_one(const Frame& frame, const std::vector<HeldSky>& skies, std::size_t slot, Selection& s) {
    HeldDistance& held = held_[slot];
    s.held_distance = held.from_view(frame.views[slot], s.block, scale_of(frame));
    if (!s.held_sky_from_view) s.held_distance.reset();
    held.is_serving_ = s.held_distance.has_value();
    if (!held.is_serving_) return;
    s.held_distance->sky_from_view = *s.held_sky_from_view;
    s.held_distance->kept.y = skies[slot].kept(s.block);
    s.reach = held.near();
}

void HeldDistances::show_at_once(const Frame& frame, const std::vector<HeldSky>& skies,
                                 std::vector<Selection>& selections) {
    if (!is_drawn_ || !drawing_ || selections[*drawing_].held_distance) return;
    const std::size_t slot = *drawing_;
    take();
    serve_one(frame, skies, slot, selections[slot]);
}

// Where the view will be in the middle of the time for which what is drawn now is shown: from this frame on if nothing
// serves, or from when it is whole, until the next one is.
bool HeldDistances::begin(const Frame& frame, const Turn& turn) {
    drawing_.reset();
    is_drawn_ = false;
    const View& view = frame.views[turn.slot];
    const Glide& glide = glides_[turn.slot];
    if (!can_hold(view) || !glide.is_known) return false;
    const bool is_at_once = turn.strips == 1 && !held_[turn.slot].is_serving_;
    const float to_middle = 0.5F * static_cast<float>(is_at_once ? kFrames : kFrames - 1);
    const float ahead = to_middle + (is_at_once ? 0 : static_cast<float>(turn.strips));
    const float moved_m = kLonger * to_middle * glm::length(glide.eye_step_m) + kStill_m;
    const float split_m =
        std::max(HeldDistance::split_m(moved_m, scale_of(frame) * pixels_per_radian(view)), kNearest_m);
    if (split_m > kFarthest_m) return false;
    view_ = widened(view);
    view_.camera.eye_m += ahead * glide.eye_step_m;
    view_.camera.target_m += ahead * glide.target_step_m;
    const glm::mat4 clip_from_world = clip_from_world_of(view_);
    const choose::ViewBlock block = block_of(view_, clip_from_world, frame.seconds);
    const glm::mat3 half{{0.5F, 0, 0}, {0, 0.5F, 0}, {0.5F, 0.5F, 1}};
    sight_ = {view.scene,
              view.viewport,
              view.camera.vertical_fov_deg,
              view_.camera.eye_m,
              half * clip_from_direction(clip_from_world),
              split_m,
              frame.seconds,
              block.to_sun.w,
              {},
              {},
              0};
    block_.fill<std::byte>(std::as_bytes(std::span(&block, 1)));
    drawing_ = turn.slot;
    return true;
}

void HeldDistances::draw_in_turn(const Frame& frame, ViewPainter& painter, std::optional<int> step, Drawn& drawn) {
    const std::optional<Turn> turn = turn_of(frames_, frame.views.size());
    if (!turn || !step) return;
    if (turn->strip == 0 ? !begin(frame, *turn) : drawing_ != turn->slot) return;
    const glm::ivec2 size = picture_size(view_, scale_of(frame));
    const GLuint framebuffer = canvas_.of(size);
    if (framebuffer == 0) return;
    const bool is_smooth = frame.detail.samples > 1 && scale_of(frame) >= 1;
    const GLuint smooth = is_smooth ? smooth_.of(size, frame.detail.samples, framebuffer) : 0;
    if (!is_smooth) smooth_.let_go();
    Stock& stock = *stocks_[turn->slot];
    const auto share = [&](std::size_t strip) { return static_cast<float>(strip) / static_cast<float>(turn->strips); };
    const glm::mat4 clip_from_world = clip_from_world_of(view_);
    Selection s(strip_of(clip_from_world, {2 * share(turn->strip) - 1, 2 * share(turn->strip + 1) - 1}),
                choose::allowance_of(frame.detail, frame.views.size()));
    s.block = block_of(view_, clip_from_world, sight_.seconds);
    s.reach = {choose::Reach::Part::Far, on_map(sight_.eye_m), sight_.split_m};
    s.strip = {2 * share(turn->strip) - 1, 2 * share(turn->strip + 1) - 1};
    look(frame, view_, stock.ground, s);
    sight_.plants.push_back(s.plants);
    sight_.gatherings.push_back(s.gathering);
    sight_.other_triangles += s.other_triangles;
    stock.cover.fill<choose::CoverInstance>(s.cover.instances);
    painter.send_plants(frame, view_, *step, s, stock, drawn);
    drawn.sent_bytes +=
        choose::kViewBlockBytes + stock.ground.sent_bytes() + s.cover.instances.size() * sizeof(choose::CoverInstance);

    glBindFramebuffer(GL_FRAMEBUFFER, smooth != 0 ? smooth : framebuffer);
    const auto pixel = [&](std::size_t strip) {
        return static_cast<int>(std::lround(share(strip) * static_cast<float>(size.x)));
    };
    glEnable(GL_SCISSOR_TEST);
    glScissor(pixel(turn->strip), 0, pixel(turn->strip + 1) - pixel(turn->strip), size.y);
    begin_drawing({0, 0, 0, 0}, false);
    gl::bind_uniforms(block_, choose::kViewBinding, 0, sizeof(choose::ViewBlock));
    painter.draw(frame, view_, s, stock, {}, {0, 0, size.x, size.y}, drawn);
    const GLenum unneeded[] = {GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT};
    glInvalidateFramebuffer(GL_FRAMEBUFFER, 2, unneeded);
    is_drawn_ = turn->strip + 1 == turn->strips;
    if (is_drawn_ && smooth != 0) smooth_.resolve(framebuffer);
    ++drawn.held_anew;
}

}  // namespace quadrat::render
