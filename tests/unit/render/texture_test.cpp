// SPDX-License-Identifier: Apache-2.0
#include "render/gl/texture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "render/gl/picture_upload.hpp"
#include "render/gl/slices.hpp"
#include "render/gl/texture_pool.hpp"
#include "unit/render/gpu_fixture.hpp"

namespace quadrat::render::gl {
namespace {

TEST(Halving, KeepsTheMean) {
    mesh::Image image(8, 4, 2);
    for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = static_cast<std::uint8_t>(i * 3);
    const mesh::Image half = halved(image);
    EXPECT_EQ(half.width, 4);
    EXPECT_EQ(half.height, 2);
    double before = 0;
    double after = 0;
    for (const auto b : image.bytes) before += b;
    for (const auto b : half.bytes) after += b;
    EXPECT_NEAR(before / static_cast<double>(image.bytes.size()), after / static_cast<double>(half.bytes.size()), 0.6);
}

TEST(Halving, EndsAtOnePixelFromAnyShape) {
    mesh::Image image(13, 3, 4);
    std::fill(image.bytes.begin(), image.bytes.end(), std::uint8_t{77});
    while (image.width > 1 || image.height > 1) image = halved(image);
    EXPECT_EQ(image.bytes, std::vector<std::uint8_t>(4, 77));
}

TEST(RootOfSrgb, SquaresBackToTheLinearColour) {
    for (int i = 0; i < 256; ++i) {
        const double e = i / 255.0;
        const double linear = e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4);
        const double root = root_of_srgb(static_cast<std::uint8_t>(i)) / 255.0;
        EXPECT_NEAR(root, std::sqrt(linear), 0.51 / 255);
    }
}

TEST(Slices, DoAboutTheBudgetAtATimeAndAllOfItInTheEnd) {
    Slices slices;
    std::size_t done = 0;
    slices.add_pieces(1000, 100, 1, [&done](std::size_t, std::size_t many) { done += many; });
    EXPECT_FALSE(slices.advance(250));
    EXPECT_EQ(done, 200U);
    EXPECT_FALSE(slices.advance(1));  // at least one piece, or nothing would ever be done
    EXPECT_EQ(done, 300U);
    while (!slices.advance(400)) continue;
    EXPECT_EQ(done, 1000U);
    EXPECT_TRUE(slices.advance(1));
}

class Pictures : public Gpu {};

TEST_F(Pictures, ArriveWholeInSmallSlices) {
    auto image = std::make_shared<mesh::Image>(300, 200, 4);
    for (std::size_t i = 0; i < image->bytes.size(); ++i) image->bytes[i] = static_cast<std::uint8_t>(i * 7 % 251);
    Slices slices;
    Texture2D texture;
    add_picture(slices, texture, image, {});
    while (!slices.advance(10'000)) continue;
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    texture.bind(0);
    GLint name = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &name);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, static_cast<GLuint>(name), 0);
    std::vector<std::uint8_t> back(image->bytes.size());
    glReadPixels(0, 0, 300, 200, GL_RGBA, GL_UNSIGNED_BYTE, back.data());
    glDeleteFramebuffers(1, &framebuffer);
    EXPECT_EQ(back, image->bytes);
}

class TexturesOfAPool : public Gpu {};

TEST_F(TexturesOfAPool, AreTakenAgainOnceNobodyHoldsThem) {
    TexturePool pool(20);
    auto first = pool.take({.width = 16, .height = 8});
    const auto second = pool.take({.width = 16, .height = 8});
    EXPECT_NE(first, second);
    EXPECT_NE(pool.take({.width = 8, .height = 8})->shape(), second->shape());
    const Texture2D* free = first.get();
    first.reset();
    EXPECT_EQ(pool.take({.width = 16, .height = 8}).get(), free);
}

TEST_F(TexturesOfAPool, GoWhenManyAreFree) {
    const std::size_t before = LiveObjects::count();
    TexturePool pool(20);
    std::vector<std::shared_ptr<const Texture2D>> held;
    for (int i = 0; i < 60; ++i) held.push_back(pool.take({.width = 4, .height = 4}));
    EXPECT_EQ(LiveObjects::count(), before + 60);
    held.clear();
    held.push_back(pool.take({.width = 8, .height = 4}));  // none of them will do
    EXPECT_LE(LiveObjects::count(), before + 25);
    EXPECT_GE(LiveObjects::count(), before + 10);
}

class LiveObjectsOnGpu : public Gpu {};

TEST_F(LiveObjectsOnGpu, AreCountedOnceAndNoLongerThanTheyLive) {
    const std::size_t before = LiveObjects::count();
    {
        Texture2D one{TextureShape{}};
        EXPECT_EQ(LiveObjects::count(), before + 1);
        Texture2D other = std::move(one);
        EXPECT_EQ(LiveObjects::count(), before + 1);
        one = Texture2D{TextureShape{}};
        EXPECT_EQ(LiveObjects::count(), before + 2);
        other = std::move(one);
        EXPECT_EQ(LiveObjects::count(), before + 1);
    }
    EXPECT_EQ(LiveObjects::count(), before);
}

}  // namespace
}  // namespace quadrat::render::gl
