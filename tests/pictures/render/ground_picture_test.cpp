// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ground_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "base/seed.hpp"
#include "pictures/handmade_scene.hpp"
#include "pictures/stage.hpp"
#include "render/passes/encode.hpp"

namespace quadrat::tests {
namespace {

using render::passes::GroundPainter;
using render::passes::MaterialOnGpu;

mesh::Image filled(int side, std::initializer_list<std::uint8_t> pixel) {
    mesh::Image image(side, side, static_cast<int>(pixel.size()));
    for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = pixel.begin()[i % pixel.size()];
    return image;
}

mesh::Image grey(int side, int level, std::uint8_t alpha) {
    const auto byte = static_cast<std::uint8_t>(level);
    return filled(side, {byte, byte, byte, alpha});
}

render::gl::Texture2D texture(const mesh::Image& image) {
    render::gl::TextureShape shape;
    shape.width = image.width;
    shape.height = image.height;
    shape.channels = image.channels;
    shape.sampling = render::gl::Sampling::Flat;
    render::gl::Texture2D made{shape};
    made.write_rows(0, 0, image.height, image.bytes);
    return made;
}

mesh::Image read_back(const render::gl::Texture2D& from, int level = 0) {
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, from.name(), level);
    mesh::Image image(from.width(level), from.height(level), 4);
    glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.bytes.data());
    glDeleteFramebuffers(1, &framebuffer);
    return image;
}

class GroundPicture : public Stage {
  protected:
    static constexpr int kSide = 32;

    // Of level, soft ground.
    mesh::Image painted(const mesh::Image& albedo, const mesh::Image& light, std::uint8_t grain = 128) {
        const scene::GroundColours colours(albedo);
        const MaterialOnGpu material{texture(filled(1, {255, 0}))};
        GroundPainter painter;
        const auto canvas = painter.canvases.take({.width = kSide, .height = kSide});
        const render::gl::Texture2D lit{canvas->shape()};
        const render::gl::Texture2D grains = texture(filled(2, {grain, grain}));
        const render::gl::Texture2D light_texture = texture(light);
        for (int row = 0; row < kSide; row += 8) {
            const mesh::Image roots = render::passes::roots_of_rows(colours, canvas->shape(), row, 8);
            painter.paint({roots.bytes, light_texture, material, 3}, grains, *canvas, row, 8);
        }
        for (int row = 0; row < kSide; row += 8) painter.copy_rows(*canvas, lit, row, 8);
        painter.copy_coarser(*canvas, lit);
        return read_back(lit);
    }
};

TEST_F(GroundPicture, IsWhatTheGroundIsMadeOfTimesItsLight) {
    for (const int albedo : {60, 140, 210}) {
        const float root = static_cast<float>(render::gl::root_of_srgb(static_cast<std::uint8_t>(albedo))) / 255;
        for (const int light : {20, 127, 220}) {
            const mesh::Image picture = painted(grey(kSide, albedo, 255), grey(4, light, 0));
            const float linear = root * root * 2 * static_cast<float>(light) / 255;
            const float shown = 255 * std::min(render::passes::encode(linear), 1.0F);
            for (const int at : {1, 15, 30})
                EXPECT_NEAR(picture.pixel(at, at)[0], shown, 1.5F) << albedo << ' ' << light;
        }
    }
}

TEST_F(GroundPicture, KeepsItsRowsAndColumns) {
    mesh::Image albedo = filled(kSide, {100, 100, 100, 255});
    for (int y = 4; y < 8; ++y)
        for (int x = 20; x < 26; ++x) albedo.pixel(x, y)[0] = 200;
    const mesh::Image picture = painted(albedo, filled(4, {127, 127, 127, 0}));
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const bool is_red = y >= 4 && y < 8 && x >= 20 && x < 26;
            EXPECT_EQ(picture.pixel(x, y)[0] > picture.pixel(x, y)[1] + 20, is_red) << x << ' ' << y;
        }
}

TEST_F(GroundPicture, TellsHowDeepWaterLooksAndIsDeepAtItsRim) {
    const mesh::Image picture = painted(filled(kSide, {100, 100, 100, 255}), filled(4, {127, 127, 127, 26}));
    const float depth_m = 24.0F * 26 / 255;
    EXPECT_NEAR(picture.pixel(9, 20)[3], 255 * (1 - std::exp(-0.35F * depth_m)), 1.5F);
    for (int i = 0; i < kSide; ++i)
        for (const std::uint8_t* rim :
             {picture.pixel(i, 0), picture.pixel(0, i), picture.pixel(i, kSide - 1), picture.pixel(kSide - 1, i)})
            EXPECT_EQ(rim[3], 255);
}

TEST_F(GroundPicture, ReliefIsBrighterWhereItFacesTheSun) {
    const mesh::Image albedo = filled(kSide, {100, 100, 100, 255});
    const mesh::Image light = filled(4, {127, 127, 127, 0});
    const int level = painted(albedo, light).pixel(9, 9)[0];
    const float share = 0.5F * render::passes::kGrain * 60 / 255;
    EXPECT_NEAR(painted(albedo, light, 188).pixel(9, 9)[0], static_cast<float>(level) * (1 + share), 1.5F);
    EXPECT_NEAR(painted(albedo, light, 68).pixel(9, 9)[0], static_cast<float>(level) * (1 - share), 1.5F);
}

TEST_F(GroundPicture, ShowsEveryLevelOfTheCanvas) {
    GroundPainter painter;
    const auto canvas = painter.canvases.take({.width = 64, .height = 32});
    base::RandomStream random{base::Seed{21}};
    mesh::Image noise(64, 32, 4);
    for (std::uint8_t& byte : noise.bytes) byte = static_cast<std::uint8_t>(random.below(256));
    render::gl::Texture2D filled_canvas{canvas->shape()};
    filled_canvas.write_rows(0, 0, 32, noise.bytes);
    filled_canvas.fill_levels();
    const render::gl::Texture2D lit{canvas->shape()};
    painter.copy_rows(filled_canvas, lit, 0, 20);
    painter.copy_rows(filled_canvas, lit, 20, 12);
    painter.copy_coarser(filled_canvas, lit);
    for (int level = 0; level < canvas->shape().levels(); ++level)
        EXPECT_EQ(read_back(lit, level), read_back(filled_canvas, level)) << level;
    const mesh::Image coarser = read_back(lit, 1);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) {
            const auto at = [&](int dx, int dy) { return int{noise.pixel(2 * x + dx, 2 * y + dy)[0]}; };
            EXPECT_NEAR(coarser.pixel(x, y)[0], 0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)), 1);
        }
}

TEST_F(GroundPicture, ACanvasIsNobodyElsesWhileItIsHeld) {
    GroundPainter painter;
    auto first = painter.canvases.take({.width = 64, .height = 64});
    const auto second = painter.canvases.take({.width = 64, .height = 64});
    EXPECT_NE(first, second);
    EXPECT_NE(painter.canvases.take({.width = 32, .height = 32})->shape(), second->shape());
    const auto* free = first.get();
    first.reset();
    EXPECT_EQ(painter.canvases.take({.width = 64, .height = 64}).get(), free);
}

// What is brought ahead, in whatever pieces, makes the same picture.
TEST_F(GroundPicture, AGroundBroughtAheadIsTheSame) {
    const auto scene = handmade_scene(Hour::Noon, Ground::Meadow);
    render::Frame f = frame();
    const auto picture_of = [&](std::shared_ptr<const render::GpuScene> gpu) {
        f.views = {{std::move(gpu), scene->track.cameras.front(), {0, 0, f.size.x, f.size.y}, 1, 0}};
        return drawn(f);
    };
    const mesh::Image at_once = picture_of(uploaded(scene));
    f.views.clear();
    const auto ahead = renderer_->begin_upload(scene::Ground{scene->flora, scene->land});
    ahead->prepare();
    int pieces = 0;
    while (!ahead->advance(1)) ++pieces;
    EXPECT_GT(pieces, 8);
    const auto rest = renderer_->begin_upload(scene);
    int left = 0;
    while (!rest->advance(1)) ++left;
    EXPECT_LT(left, pieces + 16);
    EXPECT_EQ(picture_of(rest->take()), at_once);
}

TEST_F(GroundPicture, AnUploadStopsWhenItsTimeIsOver) {
    const auto upload = renderer_->begin_upload(handmade_scene(Hour::Noon, Ground::Meadow));
    upload->prepare();
    int steps = 0;
    while (!upload->advance(static_cast<std::size_t>(-1), [] { return false; })) ++steps;
    EXPECT_GT(steps, 10);
}

// Whatever else a scene's sky has: under the sun that its land is lit by already, the grain is there.
TEST_F(GroundPicture, OneSunLightsTheGrainOnce) {
    const auto scene = handmade_scene(Hour::Noon, Ground::Meadow);
    const auto first = uploaded(scene);
    const auto pieces_under = [&](float turn) {
        auto sky = std::make_shared<scene::Sky>(*scene->sky);
        sky->sun_direction = glm::normalize(sky->sun_direction + glm::vec3{turn, 0, 0});
        auto other = std::make_shared<scene::Scene>(*scene);
        other->sky = sky;
        const auto upload = renderer_->begin_upload(other);
        int pieces = 0;
        while (!upload->advance(1)) ++pieces;
        return std::pair{pieces, upload->take()};
    };
    const auto [same, again] = pieces_under(0);
    const auto [turned, other] = pieces_under(0.3F);
    EXPECT_LT(same, turned);
    render::Frame f = frame();
    const auto picture_of = [&](std::shared_ptr<const render::GpuScene> gpu) {
        f.views = {{std::move(gpu), scene->track.cameras.front(), {0, 0, f.size.x, f.size.y}, 1, 0}};
        return drawn(f);
    };
    const mesh::Image at_once = picture_of(first);
    EXPECT_EQ(picture_of(again), at_once);
    EXPECT_NE(picture_of(other), at_once);
}

}  // namespace
}  // namespace quadrat::tests
