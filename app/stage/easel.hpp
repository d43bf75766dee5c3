// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>

#include "display/display.hpp"
#include "nursery/growing.hpp"
#include "pictures/picture.hpp"
#include "render/renderer.hpp"
#include "stage/detail_within.hpp"
#include "stage/stage.hpp"

namespace quadrat::stage {

// Draws pictures where nobody watches: a headless display with a renderer on it.
class Easel {
  public:
    Easel(int width, int height, render::GroundBy ground = render::GroundBy::Blocks);

    // Grows the picture's scenes and draws it. Its size and what draws the ground must be the easel's.
    mesh::Image draw(const pictures::Picture& picture);
    // The same in less detail, where the budget asks for it, which the picture then tells.
    mesh::Image draw(pictures::Picture& picture, const tempo::Budget& budget);
    // With scenes that are grown already.
    mesh::Image draw(const pictures::Picture& picture, const nursery::Scenes& scenes);

    display::Display& display() { return *display_; }
    render::Renderer& renderer() { return *renderer_; }

  private:
    mesh::Image draw(pictures::Picture& picture, const nursery::Scenes& scenes, const tempo::Budget& budget);

    std::unique_ptr<display::Display> display_;
    std::unique_ptr<render::Renderer> renderer_;
};

// The picture's views of a cast that is on the GPU, four of them in quarters. The canvas must have the picture's size.
render::Frame frame_of(const pictures::Picture& picture, const Cast& cast, const display::Canvas& canvas);

// A picture of scenes that are on the GPU; four of them lettered. The canvas must have the picture's size.
mesh::Image draw_picture(render::Renderer& renderer, SignWriter& writer, const pictures::Picture& picture,
                         const Cast& cast, const display::Canvas& canvas);

// The whole upload at once.
std::shared_ptr<const render::GpuScene> upload_now(render::Renderer& renderer,
                                                   std::shared_ptr<const scene::Scene> scene);

// Four quarters of a target, A at the top left, B beside it, C and D below; with a thin gap between.
std::array<render::Rect, 4> quarters(int width, int height);

}  // namespace quadrat::stage
