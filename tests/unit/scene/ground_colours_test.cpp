// SPDX-License-Identifier: Apache-2.0
#include "scene/ground_colours.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/seed.hpp"

namespace quadrat::scene {
namespace {

mesh::Image even(std::array<std::uint8_t, 4> rgba, int width, int height) {
    mesh::Image image(width, height, 4);
    for (std::size_t i = 0; i < image.bytes.size(); ++i) image.bytes[i] = rgba[i % 4];
    return image;
}

TEST(GroundColours, KeepsEveryColourWithinTwoSteps) {
    base::RandomStream random{base::Seed{3}};
    for (int i = 0; i < 2000; ++i) {
        std::array<std::uint8_t, 4> rgba{};
        for (std::uint8_t& byte : rgba) byte = static_cast<std::uint8_t>(random.below(256));
        const GroundColours colours(even(rgba, 2, 2));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(colours.colour(1, 1)[c], rgba[static_cast<std::size_t>(c)], 2);
        EXPECT_EQ(colours.wetness(1, 0), rgba[3]);
    }
}

TEST(GroundColours, GreyIsExactAndEachPixelsOwn) {
    base::RandomStream random{base::Seed{4}};
    mesh::Image image(31, 17, 4);  // odd sides too
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto level = static_cast<std::uint8_t>(random.below(256));
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = level;
        }
    const GroundColours colours(image);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t level = image.pixel(x, y)[0];
            EXPECT_EQ(colours.colour(x, y), glm::u8vec3(level, level, level)) << x << ' ' << y;
        }
}

TEST(GroundColours, HalvedRowsAreMeansOfWhatTheyCover) {
    base::RandomStream random{base::Seed{5}};
    mesh::Image image(64, 64, 4);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c)
                // Colours of ground: far from where a mean of clipped ones would differ.
                image.pixel(x, y)[c] = static_cast<std::uint8_t>(90 + random.below(60));
    const GroundColours colours(image);
    for (int halvings = 0; halvings < 4; ++halvings) {
        const int side = 1 << halvings;
        std::vector<std::uint8_t> row(static_cast<std::size_t>(4 * (64 >> halvings)));
        for (int y = 0; y < 64 >> halvings; ++y) {
            colours.mean_row(halvings, y, row);
            for (int x = 0; x < 64 >> halvings; ++x) {
                glm::vec3 mean{0};
                for (int k = 0; k < side * side; ++k)
                    mean += glm::vec3{colours.colour(x * side + k % side, y * side + k / side)};
                mean /= static_cast<float>(side * side);
                const std::size_t at = 4 * static_cast<std::size_t>(x);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(row[at + static_cast<std::size_t>(c)], mean[c], 2) << halvings << ' ' << x << ' ' << y;
                EXPECT_EQ(row[at + 3], 0);
            }
        }
    }
}

TEST(GroundColours, OfNothingThereIsNone) {
    EXPECT_TRUE(GroundColours().is_empty());
    EXPECT_FALSE(GroundColours(even({1, 2, 3, 4}, 1, 1)).is_empty());
    EXPECT_EQ(GroundColours(even({1, 2, 3, 4}, 8, 8)), GroundColours(even({1, 2, 3, 4}, 8, 8)));
    EXPECT_NE(GroundColours(even({1, 2, 3, 4}, 8, 8)), GroundColours(even({1, 2, 3, 44}, 8, 8)));
}

}  // namespace
}  // namespace quadrat::scene
