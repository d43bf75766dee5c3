// SPDX-License-Identifier: Apache-2.0
#include "render/passes/ground_brush.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "base/seed.hpp"
#include "render/gl/texture.hpp"
#include "render/passes/encode.hpp"

namespace quadrat::render::passes {
namespace {

constexpr int kSide = 32;

mesh::Image filled(int side, std::initializer_list<std::uint8_t> pixel) {
    mesh::Image image(side, side, static_cast<int>(pixel.size()));
    for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = pixel.begin()[i % pixel.size()];
    return image;
}

mesh::Image grey(int side, int level, std::uint8_t alpha) {
    const auto byte = static_cast<std::uint8_t>(level);
    return filled(side, {byte, byte, byte, alpha});
}

mesh::Image noise(int width, int height, int channels) {
    base::RandomStream random{base::Seed{21}};
    mesh::Image image(width, height, channels);
    for (std::uint8_t& byte : image.bytes) byte = static_cast<std::uint8_t>(random.below(256));
    return image;
}

mesh::Image painted(const GroundBrush::Sheet& sheet, glm::ivec2 size) {
    GroundBrush brush(sheet, size);
    mesh::Image picture(size.x, size.y, 4);
    for (int row = 0; row < size.y; ++row) brush.paint(picture, row);
    return picture;
}

// Of level, soft ground.
mesh::Image painted(const mesh::Image& albedo, const mesh::Image& light, std::uint8_t relief = 128) {
    const scene::GroundColours colours(albedo);
    return painted({colours, light, filled(1, {255, 0}), filled(1, {relief, relief}), 3}, {kSide, kSide});
}

TEST(GroundBrush, IsWhatTheGroundIsMadeOfTimesItsLight) {
    for (const int albedo : {60, 140, 210}) {
        const float root = static_cast<float>(gl::root_of_srgb(static_cast<std::uint8_t>(albedo))) / 255;
        for (const int light : {20, 127, 220}) {
            const mesh::Image picture = painted(grey(kSide, albedo, 255), grey(4, light, 0));
            const float linear = root * root * 2 * static_cast<float>(light) / 255;
            const float shown = 255 * std::min(encode(linear), 1.0F);
            for (const int at : {1, 15, 30})
                EXPECT_NEAR(picture.pixel(at, at)[0], shown, 1.0F) << albedo << ' ' << light;
        }
    }
}

// How a colour is shown on level, soft ground where one of the sheet's numbers is another.
glm::ivec3 changed(std::initializer_list<std::uint8_t> albedo, float GroundBrush::Sheet::*number, float value) {
    const scene::GroundColours colours(filled(kSide, albedo));
    const mesh::Image light = grey(4, 100, 0);
    const mesh::Image soft = filled(1, {255, 0});
    const mesh::Image level = filled(1, {128, 128});
    GroundBrush::Sheet sheet{colours, light, soft, level, 3};
    sheet.*number = value;
    const mesh::Image picture = painted(sheet, {kSide, kSide});
    const std::uint8_t* pixel = picture.pixel(9, 9);
    return {pixel[0], pixel[1], pixel[2]};
}

TEST(GroundBrush, InAWitheredSeasonPaintsStrawForGrassAndLeavesStone) {
    const auto shown = [](std::initializer_list<std::uint8_t> albedo, float withered) {
        return changed(albedo, &GroundBrush::Sheet::withered, withered);
    };
    const glm::ivec3 grass = shown({70, 110, 50, 255}, 0);
    const glm::ivec3 straw = shown({70, 110, 50, 255}, 1);
    EXPECT_LT(grass.r, grass.g);
    EXPECT_GT(straw.r, straw.g);
    EXPECT_GT(straw.g, straw.b + 20);
    EXPECT_NEAR(straw.g, grass.g, 0.1 * grass.g) << "of its lightness";
    EXPECT_EQ(shown({120, 110, 100, 255}, 1), shown({120, 110, 100, 255}, 0));
}

TEST(GroundBrush, ByNightPaintsLessColourAndLeavesGreyAlone) {
    const auto shown = [](std::initializer_list<std::uint8_t> albedo, float colour_seen) {
        return changed(albedo, &GroundBrush::Sheet::colour_seen, colour_seen);
    };
    const glm::ivec3 red = shown({160, 60, 40, 255}, 1);
    const glm::ivec3 dark = shown({160, 60, 40, 255}, 0.5F);
    EXPECT_LT(dark.r - dark.g, 0.7 * (red.r - red.g));
    EXPECT_LT(dark.r, red.r);
    const glm::ivec3 grey_by_day = shown({120, 120, 120, 255}, 1);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown({120, 120, 120, 255}, 0.5F)[c], grey_by_day[c], 1);
}

TEST(GroundBrush, KeepsRowsAndColumns) {
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

TEST(GroundBrush, TellsHowDeepWaterLooksAndIsDeepAtItsRim) {
    const mesh::Image picture = painted(filled(kSide, {100, 100, 100, 255}), filled(4, {127, 127, 127, 26}));
    const float depth_m = 24.0F * 26 / 255;
    EXPECT_NEAR(picture.pixel(9, 20)[3], 255 * (1 - std::exp(-0.35F * depth_m)), 1.0F);
    for (int i = 0; i < kSide; ++i)
        for (const std::uint8_t* rim :
             {picture.pixel(i, 0), picture.pixel(0, i), picture.pixel(i, kSide - 1), picture.pixel(kSide - 1, i)})
            EXPECT_EQ(rim[3], 255);
}

TEST(GroundBrush, ReliefIsBrighterWhereItFacesTheSun) {
    const mesh::Image albedo = filled(kSide, {100, 100, 100, 255});
    const mesh::Image light = filled(4, {127, 127, 127, 0});
    const int level = painted(albedo, light).pixel(9, 9)[0];
    const float share = 0.5F * kGrain * 60 / 255;
    EXPECT_NEAR(painted(albedo, light, 188).pixel(9, 9)[0], static_cast<float>(level) * (1 + share), 1.5F);
    EXPECT_NEAR(painted(albedo, light, 68).pixel(9, 9)[0], static_cast<float>(level) * (1 - share), 1.5F);
}

// Bands of a tile's rows lie level on a slope: one follows another over 4 m of ground that rises 2 m for each.
TEST(GroundBrush, StonesReliefLiesOnTheSlope) {
    mesh::Image bands(8, 8, 2);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) bands.pixel(x, y)[1] = y < 4 ? 40 : 216;
    mesh::Field height_m(kSide + 1, kSide + 1);
    for (int row = 0; row <= kSide; ++row)
        for (int column = 0; column <= kSide; ++column) height_m.at(column, row) = 2.0F * static_cast<float>(column);
    const mesh::Image albedo = filled(kSide, {100, 100, 100, 255});
    const scene::GroundColours colours(albedo);
    const mesh::Image light = filled(4, {127, 127, 127, 0});
    const mesh::Image stone = filled(1, {0, 255});
    GroundBrush::Sheet sheet{colours, light, stone, bands, kSide / 16.0F};
    sheet.height_m = &height_m;
    const mesh::Image picture = painted(sheet, {kSide, kSide});
    for (const int y : {3, 17, 28})
        for (int x = 1; x + 8 < kSide; x += 4) {  // where a band is widest
            EXPECT_NEAR(picture.pixel(x, y)[0], picture.pixel(x + 8, y)[0], 2) << x;
            EXPECT_GT(std::abs(picture.pixel(x, y)[0] - picture.pixel(x + 4, y)[0]), 12) << x;
            EXPECT_NEAR(picture.pixel(x, y)[0], picture.pixel(x, 10)[0], 2) << "as high, as bright";
        }
}

// Pixel by pixel, in double precision, as a GPU would fetch it.
double bilinear(const mesh::Image& image, double x, double y, int channel, bool is_tiled) {
    const auto at = [&](double column, double row) {
        const auto inside = [is_tiled](double place, int count) {
            return is_tiled ? static_cast<int>(place - count * std::floor(place / count))
                            : std::clamp(static_cast<int>(place), 0, count - 1);
        };
        return double{
            static_cast<double>(image.pixel(inside(column, image.width), inside(row, image.height))[channel])};
    };
    const double left = std::floor(x);
    const double upper = std::floor(y);
    return std::lerp(std::lerp(at(left, upper), at(left + 1, upper), x - left),
                     std::lerp(at(left, upper + 1), at(left + 1, upper + 1), x - left), y - upper);
}

TEST(GroundBrush, IsTheFetchOfEachOfItsPixels) {
    constexpr glm::ivec2 kSize{48, 24};
    const mesh::Image albedo = noise(kSize.x, kSize.y, 4);
    const scene::GroundColours colours(albedo);
    const mesh::Image light = noise(7, 5, 4);
    const mesh::Image kinds = noise(13, 9, 2);
    const mesh::Image relief = noise(16, 8, 2);
    constexpr float kTiles = 2.7F;
    const mesh::Image picture = painted({colours, light, kinds, relief, kTiles}, kSize);
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const double u = (x + 0.5) / kSize.x;
            const double v = (y + 0.5) / kSize.y;
            const auto lit = [&](int c) { return bilinear(light, u * 7 - 0.5, v * 5 - 0.5, c, false) / 255; };
            const double east = (u - 0.5) * kTiles;
            const double south = (v - 0.5) * kTiles;
            double relieved = 1;
            for (int c = 0; c < 2; ++c)
                relieved +=
                    0.5 * kGrain *
                    (bilinear(relief, (east - 0.5 * south) * 16 - 0.5, (south + 0.5 * east) * 8 - 0.5, c, true) / 255 -
                     0.5) *
                    bilinear(kinds, u * 12, v * 8, c, false) / 255;
            const glm::u8vec3 colour = colours.colour(x, y);
            for (int c = 0; c < 3; ++c) {
                const double root = gl::root_of_srgb(colour[c]) / 255.0 * std::sqrt(2 * lit(c));
                const double shown = encode_root(static_cast<float>(root)) * relieved;
                ASSERT_NEAR(picture.pixel(x, y)[c], 255 * std::clamp(shown, 0.0, 1.0), 0.6) << x << ' ' << y;
            }
            const bool is_rim = x == 0 || y == 0 || x == kSize.x - 1 || y == kSize.y - 1;
            const double depth = 255 * (1 - std::exp(-0.35 * 24 * lit(3)));
            ASSERT_NEAR(picture.pixel(x, y)[3], is_rim ? 255 : depth, 0.6) << x << ' ' << y;
        }
}

TEST(GroundBrush, ASmallerPictureIsTheMeanOfAFineOne) {
    const mesh::Image albedo = noise(64, 64, 4);
    const scene::GroundColours colours(albedo);
    const mesh::Image light = filled(4, {127, 127, 127, 0});
    const mesh::Image kinds = filled(1, {0, 0});
    const mesh::Image level = filled(1, {128, 128});
    const mesh::Image coarse = painted({colours, light, kinds, level, 1}, {16, 16});
    std::vector<std::uint8_t> mean(std::size_t{4} * 16);
    colours.mean_row(2, 7, mean);
    for (int x = 0; x < 16; ++x) {
        const float root = static_cast<float>(gl::root_of_srgb(mean[4 * static_cast<std::size_t>(x)])) / 255;
        EXPECT_NEAR(coarse.pixel(x, 7)[0], 255 * encode_root(root * std::sqrt(2 * 127.0F / 255)), 1) << x;
    }
}

// Under water the bed gives way to the water's own colour, the more the deeper it looks; on land nothing changes.
TEST(GroundBrush, ShowsTheBedThroughTheWaterOverIt) {
    const mesh::Image kinds = filled(kSide, {0, 0});
    const mesh::Image relief = filled(kSide, {128, 128});
    const scene::GroundColours colours(grey(kSide, 150, 0));
    const glm::vec3 water{0.1F, 0.5F, 0.6F};
    const auto middle = [&](std::uint8_t depth, float murk) {
        const mesh::Image light = grey(kSide, 128, depth);
        return *reinterpret_cast<const std::array<std::uint8_t, 4>*>(
            painted({colours, light, kinds, relief, 1, water, murk}, {kSide, kSide}).pixel(kSide / 2, kSide / 2));
    };
    EXPECT_EQ(middle(0, 0.8F), middle(0, 0));
    const auto clear = middle(120, 0);
    const auto murky = middle(120, 0.8F);
    // So deep, it is hidden as far as it ever is.
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(murky[c], 0.2F * clear[c] + 0.8F * 255 * water[static_cast<int>(c)], 1.5F) << c;
    const auto shallow = middle(3, 0.8F);
    EXPECT_LT(std::abs(shallow[1] - clear[1]), std::abs(murky[1] - clear[1]) + 1);
}

}  // namespace
}  // namespace quadrat::render::passes
