// SPDX-License-Identifier: Apache-2.0
#include "render/selection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/choose/falling.hpp"
#include "render/gpu_scene.hpp"
#include "render/view.hpp"

namespace quadrat::render {
namespace {

// Of what is held from frame to frame, how much counts among them. A frame draws a quarter of it; more of the rest
// would be gained, but a landscape is to look much alike however much of it can be held.
constexpr float kHeldShare = 0.6F;
constexpr float kLeastScale = 0.25F;  // of the sides of what is drawn smaller than it is shown
// What moonlight leaves of a plant's light: crowns stand dark before the ground.
constexpr glm::vec3 kMoonlit{0.58F};

glm::mat4 turned(const glm::mat4& clip_from_world, const Hanging& hanging) {
    glm::mat4 turn{1};
    const glm::mat2 turn_xy = panel_from_upright(hanging);
    turn[0] = {turn_xy[0], 0, 0};
    turn[1] = {turn_xy[1], 0, 0};
    return turn * clip_from_world;
}

// Houses come one by one, and the selection is not made anew for each.
float standing_at(float growth) {
    constexpr float kSteps = 48;
    return std::ceil(std::clamp(growth, 0.0F, 1.0F) * kSteps) / kSteps;
}

}  // namespace

float scale_of(const Frame& frame) { return std::clamp(frame.detail.scale, kLeastScale, 1.0F); }

bool draws_plants(const Frame& frame) { return frame.measured.leaves || frame.measured.wood; }

Selection outline(const Frame& frame, std::size_t slot) {
    const View& view = frame.views[slot];
    const glm::mat4 clip_from_world = clip_from_world_of(view);
    Selection s(clip_from_world, choose::allowance_of(frame.detail, frame.views.size()));
    s.block = block_of(view, turned(clip_from_world, frame.hanging), frame.seconds);
    s.reach = {frame.measured.part, {view.camera.eye_m.x, view.camera.eye_m.z}, frame.measured.split_m};
    return s;
}

void look(const Frame& frame, const View& view, HeldGround& held, Selection& s) {
    const GpuScene& scene = *view.scene;
    const float scale = pixels_per_radian(view);
    // A picture by itself does not hang on the frames before it.
    if (!frame.is_one_of_many) held.drop();
    if (frame.measured.ground)
        held.update(view, clip_from_world_of(view),
                    {s.allowance, scale, aspect_ratio(view), s.reach, s.strip, standing_at(view.growth)});
    else
        held.drop();
    if (frame.measured.ground) {
        s.cover_wish = {
            &s.block, &scene.sky->shadow_map, scale, s.allowance.cover_whole, s.allowance.cover_reach, view.growth,
            s.reach};
        s.cover = choose::look_at_cover(scene.cover, s.frustum, s.cover_wish);
    }
    if (!draws_plants(frame)) return;

    s.gathering.view = s.block;
    s.gathering.clouds = &scene.sky->shadow_map;
    s.gathering.pixels_per_radian = scale;
    s.gathering.scale = scale_of(frame);
    s.gathering.tint = glm::mix(glm::vec3{1}, kMoonlit, scene.air.sky.darkness);
    s.gathering.growth = view.growth;
    s.gathering.fineness = s.allowance.plant_fineness;
    s.gathering.horizon = &held.horizon();
    s.gathering.reach = s.reach;
    s.plants = choose::look(*scene.plants, scene.flora->kinds, s.frustum, s.gathering);
    s.other_triangles = held.triangles() + s.cover.triangles +
                        (frame.measured.sky && s.reach.part != choose::Reach::Part::Far
                             ? 2 * choose::drops_of(scene.air.sky.precipitation, s.allowance.drops)
                             : 0);
}

int affordable_step(const Frame& frame, const std::vector<Selection>& selections, HeldTriangles held,
                    std::optional<int> before) {
    std::vector<choose::Crowding> views = std::move(held.plants);
    for (choose::Crowding& view : views) view.share = kHeldShare;
    auto others = static_cast<std::size_t>(kHeldShare * static_cast<float>(held.others));
    for (std::size_t i = 0; i < selections.size(); ++i) {
        const Selection& s = selections[i];
        views.push_back({frame.views[i].scene->flora->kinds, &s.gathering, &s.plants});
        others += s.other_triangles;
    }
    const choose::Allowance allowance = choose::allowance_of(frame.detail, frame.views.size());
    const auto budget = static_cast<std::size_t>(allowance.triangles);
    const auto fewest = static_cast<std::size_t>(allowance.fewest_plant_triangles);
    return choose::affordable_step(views, std::max(budget, others + fewest) - others, before);
}

}  // namespace quadrat::render
