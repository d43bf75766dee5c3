// SPDX-License-Identifier: Apache-2.0
#include "stage/easel.hpp"

#include <algorithm>

#include "nursery/growing.hpp"
#include "stage/signs.hpp"

namespace quadrat::stage {
namespace {

std::unique_ptr<display::Display> open_headless(int width, int height) {
    display::DisplayOptions options;
    options.kind = display::Kind::Headless;
    options.size = {width, height};
    return display::open_display(options);
}

}  // namespace

std::array<render::Rect, 4> quarters(int width, int height) {
    const int gap = std::max(2, height / 240);
    const int left = (width - gap) / 2;
    const int low = (height - gap) / 2;
    const int x = width - left;
    const int y = height - low;
    return {{{0, y, left, low}, {x, y, left, low}, {0, 0, left, low}, {x, 0, left, low}}};
}

std::shared_ptr<const render::GpuScene> upload_now(render::Renderer& renderer,
                                                   std::shared_ptr<const scene::Scene> scene) {
    const auto upload = renderer.begin_upload(std::move(scene));
    while (!upload->advance(static_cast<std::size_t>(-1))) {
    }
    return upload->take();
}

Easel::Easel(int width, int height, render::GroundBy ground) : display_(open_headless(width, height)) {
    display_->begin_frame();
    renderer_ = std::make_unique<render::Renderer>(ground);
}

mesh::Image Easel::draw(const pictures::Picture& picture) {
    pictures::Picture drawn = picture;
    return draw(drawn, tempo::Budget{});
}

mesh::Image Easel::draw(pictures::Picture& picture, const tempo::Budget& budget) {
    nursery::Scenes scenes;
    for (const genome::Recipe& recipe : picture.scenes)
        scenes.push_back(nursery::grow(recipe, pictures::fineness_of(picture.land_samples)));
    return draw(picture, scenes, budget);
}

mesh::Image Easel::draw(const pictures::Picture& picture, const nursery::Scenes& scenes) {
    pictures::Picture drawn = picture;
    return draw(drawn, scenes, {});
}

render::Frame frame_of(const pictures::Picture& picture, const Cast& cast, const display::Canvas& canvas) {
    render::Frame frame;
    frame.size = {canvas.size.width, canvas.size.height};
    frame.framebuffer = canvas.framebuffer;
    frame.seconds = picture.seconds;
    frame.detail = {picture.alpha, picture.scale, picture.samples};
    frame.is_wired = picture.has_wires;
    const auto places = quarters(frame.size.x, frame.size.y);
    const bool is_four = cast.scenes.size() > 1;
    for (std::size_t i = 0; i < std::min(cast.scenes.size(), places.size()); ++i) {
        render::View view;
        view.scene = cast.scenes[i].gpu;
        view.camera = picture.camera.value_or(scene::camera_at(cast.scenes[i].scene->track, picture.seconds));
        view.viewport = is_four ? places[i] : render::Rect{0, 0, frame.size.x, frame.size.y};
        view.growth = picture.growth;
        frame.views.push_back(std::move(view));
    }
    return frame;
}

mesh::Image Easel::draw(pictures::Picture& picture, const nursery::Scenes& scenes, const tempo::Budget& budget) {
    const display::Canvas canvas = display_->begin_frame();
    Cast cast;
    for (const auto& scene : scenes) cast.scenes.push_back({scene, upload_now(*renderer_, scene)});
    render::Frame frame = frame_of(picture, cast, canvas);
    const render::Detail detail = detail_within(budget, frame.size, frame.detail, [&](const render::Detail& tried) {
        frame.detail = tried;
        return renderer_->draw(frame).triangles;
    });
    picture.alpha = detail.alpha;
    picture.scale = detail.scale;
    SignWriter writer(*renderer_);
    mesh::Image pixels = draw_picture(*renderer_, writer, picture, cast, canvas);
    display_->present();
    return pixels;
}

mesh::Image draw_picture(render::Renderer& renderer, SignWriter& writer, const pictures::Picture& picture,
                         const Cast& cast, const display::Canvas& canvas) {
    render::Frame frame = frame_of(picture, cast, canvas);
    if (frame.views.size() > 1) frame.signs = writer.badges(frame.size.x, frame.size.y);
    renderer.draw(frame);
    return renderer.read_pixels(frame);
}

}  // namespace quadrat::stage
