// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <cmath>
#include <memory>
#include <vector>

#include "display/display.hpp"
#include "mesh/image.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"
#include "stage/easel.hpp"

// Flights drawn frame after frame, with what is far held or drawn anew each time.
namespace quadrat::tests {

struct Off {
    double rms = 0;    // over colours and pixels, in steps of 255
    double worst = 0;  // the same of the tile where it is most
};

// Tiles of 16 by 16. Pictures of one size, four channels.
inline Off off(const mesh::Image& a, const mesh::Image& b) {
    constexpr int kTile = 16;
    const int across = (a.width + kTile - 1) / kTile;
    std::vector<double> sums(static_cast<std::size_t>(across * ((a.height + kTile - 1) / kTile)));
    double sum = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t at =
                4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(x));
            double square = 0;
            for (std::size_t c = 0; c < 3; ++c) square += std::pow(int{a.bytes[at + c]} - int{b.bytes[at + c]}, 2);
            sum += square;
            sums[static_cast<std::size_t>(y / kTile * across + x / kTile)] += square;
        }
    }
    Off off;
    off.rms = std::sqrt(sum / (3.0 * a.width * a.height));
    for (const double s : sums) off.worst = std::max(off.worst, std::sqrt(s / (3.0 * kTile * kTile)));
    return off;
}

// With a renderer of its own on the easel's display.
class Flight {
  public:
    struct Shown {
        mesh::Image pixels;
        render::Drawn drawn;
        double ms = 0;  // to draw it, all of it done
    };

    Flight(stage::Easel& easel, const std::vector<std::shared_ptr<const scene::Scene>>& scenes, glm::ivec2 size,
           bool is_held)
        : easel_(easel), scenes_(scenes) {
        frame.size = size;
        frame.is_one_of_many = true;
        frame.holds_distance = is_held;
        const auto places = stage::quarters(size.x, size.y);
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            render::View view;
            view.scene = stage::upload_now(renderer_, scenes[i]);
            view.viewport = scenes.size() == 1 ? render::Rect{0, 0, size.x, size.y} : places[i];
            frame.views.push_back(view);
        }
    }

    // Where its scenes' flights are then.
    Shown draw(float seconds) {
        for (std::size_t i = 0; i < scenes_.size(); ++i)
            frame.views[i].camera = scene::camera_at(scenes_[i]->track, seconds);
        frame.seconds = seconds;
        return draw();
    }
    // With cameras as they are.
    Shown draw() {
        const display::Canvas canvas = easel_.display().begin_frame();
        frame.framebuffer = canvas.framebuffer;
        Shown shown;
        const auto begin = std::chrono::steady_clock::now();
        shown.drawn = renderer_.draw(frame);
        renderer_.finish();
        shown.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        shown.pixels = renderer_.read_pixels(frame);
        easel_.display().present();
        return shown;
    }

    render::Frame frame;

  private:
    stage::Easel& easel_;
    render::Renderer renderer_;
    std::vector<std::shared_ptr<const scene::Scene>> scenes_;
};

}  // namespace quadrat::tests
