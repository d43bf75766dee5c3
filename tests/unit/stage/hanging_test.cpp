// SPDX-License-Identifier: Apache-2.0
// A panel that hangs on its side, or is lit from behind: the same picture, turned.
#include "render/hanging.hpp"

#include <gtest/gtest.h>

#include "stage/easel.hpp"

namespace quadrat::stage {
namespace {

using render::Hanging;
using render::Rect;

constexpr glm::ivec2 kUpright{90, 160};

TEST(Hanging, ARectangleGoesWhereTheMatrixTurnsIt) {
    const Rect r{10, 20, 30, 40};
    for (int turns = 0; turns < 4; ++turns) {
        for (const bool is_mirrored : {false, true}) {
            const Hanging hanging{turns, is_mirrored};
            const glm::vec2 size{kUpright};
            const glm::vec2 panel{render::turned_size(kUpright, hanging)};
            const glm::vec2 middle{static_cast<float>(r.x) + 15, static_cast<float>(r.y) + 20};
            const glm::vec2 clip = render::panel_from_upright(hanging) * (2.0F * middle / size - 1.0F);
            const Rect turned = on_panel(r, kUpright, hanging);
            const glm::vec2 expected{static_cast<float>(turned.x) + static_cast<float>(turned.width) / 2,
                                     static_cast<float>(turned.y) + static_cast<float>(turned.height) / 2};
            const glm::vec2 at = (clip + 1.0F) / 2.0F * panel;
            EXPECT_NEAR(at.x, expected.x, 1e-3F) << turns << is_mirrored;
            EXPECT_NEAR(at.y, expected.y, 1e-3F) << turns << is_mirrored;
        }
    }
}

// The pixel of the panel that shows the upright pixel (x, y from the top), by walking the matrix.
glm::ivec2 shown_at(int x, int y, const Hanging& hanging) {
    const Rect pixel{x, kUpright.y - 1 - y, 1, 1};
    const Rect there = on_panel(pixel, kUpright, hanging);
    return {there.x, render::turned_size(kUpright, hanging).y - 1 - there.y};
}

mesh::Image drawn(Easel& easel, const std::shared_ptr<const render::GpuScene>& scene, const scene::Camera& camera,
                  const Hanging& hanging) {
    const display::Canvas canvas = easel.display().begin_frame();
    render::Frame frame;
    frame.framebuffer = canvas.framebuffer;
    frame.size = kUpright;
    frame.hanging = hanging;
    frame.views.push_back({scene, camera, {0, 0, kUpright.x, kUpright.y}, 1, 0});
    SignWriter writer(easel.renderer());
    for (auto& sign : writer.badges(kUpright.x, kUpright.y)) frame.signs.push_back(std::move(sign));
    easel.renderer().draw(frame);
    return easel.renderer().read_pixels(frame);
}

TEST(Hanging, EveryTurnShowsTheSamePicture) {
    const auto scene = nursery::grow(genome::random_recipe(base::Seed{3}), {65, 64, 128});
    const scene::Camera camera = scene::camera_at(scene->track, 0);
    mesh::Image upright;
    for (int turns = 0; turns < 4; ++turns) {
        for (const bool is_mirrored : {false, true}) {
            const Hanging hanging{turns, is_mirrored};
            const glm::ivec2 panel = render::turned_size(kUpright, hanging);
            Easel easel(panel.x, panel.y);
            const mesh::Image image = drawn(easel, upload_now(easel.renderer(), scene), camera, hanging);
            if (upright.bytes.empty()) upright = image;
            double difference = 0;
            for (int y = 0; y < kUpright.y; ++y) {
                for (int x = 0; x < kUpright.x; ++x) {
                    const glm::ivec2 at = shown_at(x, y, hanging);
                    for (int c = 0; c < 3; ++c)
                        difference += std::abs(image.pixel(at.x, at.y)[c] - upright.pixel(x, y)[c]);
                }
            }
            // Edges fall on other sides of pixel middles when turned; anything misplaced is far above this.
            EXPECT_LT(difference / (3.0 * kUpright.x * kUpright.y), 4.0) << turns << is_mirrored;
        }
    }
}

}  // namespace
}  // namespace quadrat::stage
