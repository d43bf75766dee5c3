// SPDX-License-Identifier: Apache-2.0
#include "render/lettering.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quadrat::render {
namespace {

double ink(const mesh::Image& image, int channel) {
    double sum = 0;
    for (std::size_t i = static_cast<std::size_t>(channel); i < image.bytes.size(); i += 4) sum += image.bytes[i];
    return sum / 255;
}

TEST(Lettering, MakesPremultipliedPictures) {
    for (const auto& image : {letter("Trees?", {}), badge(Shape::Triangle, "B", {0.3F, 0.7F, 0.9F, 1}, 96)}) {
        for (std::size_t i = 0; i < image.bytes.size(); i += 4)
            for (std::size_t c = 0; c < 3; ++c) ASSERT_LE(image.bytes[i + c], image.bytes[i + 3]);
        EXPECT_GT(ink(image, 0), 50);
    }
}

TEST(Lettering, GrowsWithTheTextAndWithItsSize) {
    const auto small = letter("Welches Land?", {.size_px = 20});
    const auto large = letter("Welches Land?", {.size_px = 40});
    const auto longer = letter("Welches Land gefällt dir?", {.size_px = 20});
    EXPECT_GT(large.height, small.height * 3 / 2);
    EXPECT_GT(large.width, small.width * 3 / 2);
    EXPECT_GT(longer.width, small.width);
}

TEST(Lettering, WrapsAtTheWidthItIsGiven) {
    const auto line = letter("one two three four five six", {.size_px = 24, .shadow_px = 0});
    const auto wrapped = letter("one two three four five six", {.size_px = 24, .max_width_px = 120, .shadow_px = 0});
    EXPECT_LE(wrapped.width, 124);
    EXPECT_GT(wrapped.height, line.height * 3 / 2);
}

TEST(Lettering, GivesOneClearPixelForNoText) {
    const auto nothing = letter("", {});
    EXPECT_EQ(nothing.width, 1);
    EXPECT_EQ(nothing.height, 1);
    EXPECT_EQ(ink(nothing, 3), 0);
}

TEST(Lettering, SurroundsLettersWithADarkHalo) {
    const auto plain = letter("A", {.size_px = 48, .shadow_px = 0});
    const auto haloed = letter("A", {.size_px = 48, .shadow_px = 3});
    EXPECT_GT(haloed.width, plain.width);
    EXPECT_GT(ink(haloed, 3), 1.2 * ink(plain, 3));   // covers more,
    EXPECT_NEAR(ink(haloed, 0), ink(plain, 0), 1.0);  // and is no brighter
}

TEST(Lettering, KnowsOtherScripts) {
    for (const char* word : {"أشجار", "樹木", "Δέντρα", "पेड़"})
        EXPECT_GT(ink(letter(word, {.size_px = 40}), 0), 40) << word;
}

TEST(Badges, AreAboutEquallyLargeWhateverTheirShape) {
    double least = 1e9;
    double most = 0;
    for (const Shape shape : {Shape::Circle, Shape::Triangle, Shape::Square, Shape::Diamond}) {
        const auto image = badge(shape, "", {1, 1, 1, 1}, 128);
        EXPECT_EQ(image.width, 128);
        const double area = ink(image, 0);
        least = std::min(least, area);
        most = std::max(most, area);
    }
    EXPECT_LT(most, 1.45 * least);
}

TEST(Badges, KeepTheirOutlineInsideThePicture) {
    for (const Shape shape : {Shape::Circle, Shape::Triangle, Shape::Square, Shape::Diamond}) {
        const auto image = badge(shape, "W", {0.9F, 0.6F, 0, 1}, 96);
        for (int i = 0; i < 96; ++i) {
            for (const auto* edge : {image.pixel(i, 0), image.pixel(i, 95), image.pixel(0, i), image.pixel(95, i)})
                EXPECT_EQ(edge[0], 0);
        }
    }
}

}  // namespace
}  // namespace quadrat::render
