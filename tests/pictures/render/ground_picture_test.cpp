// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ground_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/seed.hpp"
#include "pictures/handmade_scene.hpp"
#include "pictures/stage.hpp"
#include "render/passes/encode.hpp"

namespace quadrat::tests {
namespace {

using render::passes::GroundPainter;
using render::passes::GroundPictureOnGpu;
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
        GroundPictureOnGpu picture;
        render::gl::TextureShape shape;
        shape.width = shape.height = kSide;
        picture.lit = render::gl::Texture2D{shape};
        picture.grain = texture(filled(2, {grain, grain}));
        GroundPainter painter;
        const render::gl::Texture2D light_texture = texture(light);
        for (int row = 0; row < kSide; row += 8) painter.paint({light_texture, material, colours, 3}, picture, row, 8);
        return read_back(picture.lit);
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

TEST_F(GroundPicture, EveryCoarserLevelIsTheMeanOfTheFinerOne) {
    constexpr int kFinest = 160;  // more rows than are drawn at once
    mesh::Image noise(kFinest, kFinest, 4);
    base::RandomStream random{base::Seed{21}};
    for (std::uint8_t& byte : noise.bytes) byte = static_cast<std::uint8_t>(random.below(256));
    GroundPictureOnGpu picture;
    render::gl::TextureShape shape;
    shape.width = shape.height = kFinest;
    picture.lit = render::gl::Texture2D{shape};
    picture.lit.write_rows(0, 0, kFinest, noise.bytes);
    GroundPainter painter;
    for (int level = 1; level < 6; ++level) {
        const int height = picture.lit.height(level);
        for (int row = 0; row < height; row += GroundPainter::kMostRows)
            painter.halve(picture, level, row, std::min(GroundPainter::kMostRows, height - row));
        const mesh::Image finer = read_back(picture.lit, level - 1);
        const mesh::Image coarser = read_back(picture.lit, level);
        ASSERT_EQ(coarser.height, kFinest >> level);
        for (int y = 0; y < coarser.height; ++y)
            for (int x = 0; x < coarser.width; ++x)
                for (int c = 0; c < 4; ++c) {
                    const auto at = [&](int dx, int dy) { return int{finer.pixel(2 * x + dx, 2 * y + dy)[c]}; };
                    const int sum = at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1);
                    ASSERT_NEAR(coarser.pixel(x, y)[c], 0.25 * sum, 1) << level << ' ' << x << ' ' << y;
                }
    }
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

}  // namespace
}  // namespace quadrat::tests
