// SPDX-License-Identifier: Apache-2.0
#include "render/view_painter.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "render/gl/wires.hpp"
#include "render/gpu_scene.hpp"
#include "render/passes/cloud_shadow.hpp"
#include "render/view.hpp"

namespace quadrat::render {
namespace {

gl::Work& of(Drawn& drawn, DrawnKind kind) { return drawn.of[static_cast<std::size_t>(kind)]; }

}  // namespace

void begin_drawing(const glm::vec4& colour, bool is_mirrored) {
    glDepthMask(GL_TRUE);
    glClearColor(colour.r, colour.g, colour.b, colour.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glFrontFace(is_mirrored ? GL_CW : GL_CCW);
    glDepthFunc(GL_LEQUAL);
}

void ViewPainter::send_plants(const Frame& frame, const View& view, int step, Selection& s, Stock& stock,
                              Drawn& drawn) {
    if (!draws_plants(frame)) return;
    const GpuScene& scene = *view.scene;
    view_instances_.clear();
    choose::Crowd crowd =
        choose::gather(*scene.plants, scene.flora->kinds, std::move(s.plants), step, s.gathering, view_instances_);
    s.batches = std::move(crowd.batches);
    std::erase_if(s.batches, [&](const choose::Batch& batch) {
        return batch.part == choose::Batch::Part::Wood ? !frame.measured.wood : !frame.measured.leaves;
    });
    stock.instances.fill<choose::Instance>(view_instances_);
    drawn.sent_bytes += view_instances_.size() * sizeof(choose::Instance);
}

void ViewPainter::draw(const Frame& frame, const View& view, const Selection& selection, const Stock& stock,
                       const Held& held, const Rect& place, Drawn& drawn) const {
    glViewport(place.x, place.y, place.width, place.height);
    const Measured& what = frame.measured;
    std::optional<passes::NearMarks> marks;
    if (selection.held_distance) marks.emplace();
    if (marks) marks->begin_plants();
    if (what.leaves || what.wood) draw_plants(view, selection, stock, drawn);
    if (marks) marks->begin_others();
    if (what.ground) draw_ground(view, selection, stock, drawn);
    if (what.water) draw_water(frame, view, selection, drawn);
    if (marks) marks->begin_distance();
    if (what.sky && !gl::Wires::are_on()) draw_sky(view, selection, held, place, drawn);
    marks.reset();
    if (what.sky && !gl::Wires::are_on())
        of(drawn, DrawnKind::Falling) += smoke_.draw(view.scene->country->smoke, view.scene->air.sky.clouds[0].wind_m_s,
                                                     view.growth, selection.reach);
    if (what.sky && !gl::Wires::are_on() && selection.reach.part != choose::Reach::Part::Far)
        of(drawn, DrawnKind::Falling) += falling_.draw(view.scene->air.sky.precipitation, selection.block,
                                                       pixels_per_radian(view), selection.allowance.drops);
}

void ViewPainter::draw_plants(const View& view, const Selection& selection, const Stock& stock, Drawn& drawn) const {
    const passes::PlantsPass::Drawn trees =
        plants_.draw(*view.scene->flora, selection.batches, stock.instances, selection.block);
    of(drawn, DrawnKind::Leaves) += trees.leaves;
    of(drawn, DrawnKind::Wood) += trees.wood;
}

void ViewPainter::draw_ground(const View& view, const Selection& selection, const Stock& stock, Drawn& drawn) const {
    const GpuScene& scene = *view.scene;
    const CountryOnGpu& country = *scene.country;
    const HeldGround& held = stock.ground;
    gl::bind_uniforms(scene.sky->shadow, passes::kShadowBinding);
    of(drawn, DrawnKind::Cover) += cover_.draw(scene.cover, selection.cover, stock.cover);
    gl::Work& work = of(drawn, DrawnKind::Ground);
    work += houses_.draw(country.houses, held.indices(), held.houses());
    work += stone_.draw(country.stone, scene.ground, held.indices(), held.stone());
    if (gl::Wires::are_on()) {
        for (const choose::IndexRange& level : held.land_by_level())
            work += ground_.draw(country.land, scene.ground, held.level_indices(), level, held.grain_m());
    } else {
        work += ground_.draw(country.land, scene.ground, held.indices(), held.land(), held.grain_m());
    }
    work += surround_.draw(country.land, scene.ground, held.indices(), held.surround());
}

void ViewPainter::draw_water(const Frame& frame, const View& view, const Selection& selection, Drawn& drawn) const {
    const GpuScene& scene = *view.scene;
    const CountryOnGpu& country = *scene.country;
    const glm::vec3 eye_m = view.camera.eye_m;
    gl::Work& work = of(drawn, DrawnKind::Water);
    // As many pixels as the lines of a finer or smaller picture ask for.
    const float nearness = selection.allowance.water_nearness * scale_of(frame) * pixels_per_radian(view) /
                           choose::WaterLevels::kPixelsPerRadian;
    work += water_.draw_fresh(country.fresh_water, *scene.ground.lit, scene.mirror,
                              country.fresh_water.levels.seen(selection.frustum, eye_m, nearness, selection.reach));
    // The sea after it: where a river's mouth lies over the sea, one of them is seen.
    if (country.land.has_water)
        work += water_.draw(*scene.ground.lit, scene.mirror, selection.frustum, eye_m, selection.reach);
}

// Of what is far the lights alone, where they are seen past it.
void ViewPainter::draw_sky(const View& view, const Selection& selection, const Held& held, const Rect& place,
                           Drawn& drawn) const {
    const GpuScene& scene = *view.scene;
    gl::Work& work = of(drawn, DrawnKind::Sky);
    if (selection.held_distance) {
        work += distance_.draw(*held.distance, held.sky->picture(), *selection.held_distance);
        return;
    }
    if (selection.held_sky_from_view)
        work += sky_.draw_held(held.sky->picture(), *selection.held_sky_from_view, held.sky->kept(selection.block));
    else if (selection.reach.part != choose::Reach::Part::Far)
        work += sky_.draw_dome(*scene.sky, selection.frustum, view.camera.eye_m);
    work += sky_.draw_lights(*scene.sky, place.height, selection.allowance.stars);
}

}  // namespace quadrat::render
