// SPDX-License-Identifier: Apache-2.0
// The four signs, as people see them who lack a kind of cone.
#include <gtest/gtest.h>

#include <cstdlib>

#include "pictures/picture.hpp"
#include "render/lettering.hpp"
#include "stage/marks.hpp"
#include "stage/signs.hpp"
#include "support/colour_vision.hpp"

namespace quadrat::stage {
namespace {

using tests::Colour;
using tests::kVisions;
using tests::Vision;

constexpr int kSide = 128;

mesh::Image badge_of(std::size_t index) {
    return render::badge(quarter(index).shape, quarter(index).letter, quarter(index).colour, kSide);
}

// Of the sign's own colour, most of all that is opaque in it.
Colour colour_of(const Vision& vision, const mesh::Image& badge, std::size_t index) {
    const glm::vec4& own = quarter(index).colour;
    Colour sum{};
    int count = 0;
    for (int y = 0; y < badge.height; ++y)
        for (int x = 0; x < badge.width; ++x) {
            const std::uint8_t* pixel = badge.pixel(x, y);
            if (pixel[3] < 255 || std::abs(pixel[0] - 255 * own.r) > 3 || std::abs(pixel[1] - 255 * own.g) > 3)
                continue;
            const Colour one =
                tests::seen(vision, {tests::linear_of(pixel[0] / 255.0), tests::linear_of(pixel[1] / 255.0),
                                     tests::linear_of(pixel[2] / 255.0)});
            for (std::size_t i = 0; i < 3; ++i) sum[i] += one[i];
            ++count;
        }
    EXPECT_GT(count, kSide * kSide / 8) << "the sign is filled with it";
    for (double& channel : sum) channel /= std::max(1, count);
    return sum;
}

TEST(ColourVision, KeepsTheFourSignsApartByLuminance) {
    for (const Vision& vision : kVisions)
        for (std::size_t i = 0; i < kQuarters; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const double one = tests::luminance(colour_of(vision, badge_of(i), i)) + 0.05;
                const double other = tests::luminance(colour_of(vision, badge_of(j), j)) + 0.05;
                EXPECT_GE(std::max(one, other) / std::min(one, other), 1.5)
                    << vision.name << ": " << quarter(i).letter << " and " << quarter(j).letter;
            }
}

// Of two silhouettes: what is in one of them alone, to what is in either.
TEST(ColourVision, KeepsTheFourSignsApartByShapeAlone) {
    for (std::size_t i = 0; i < kQuarters; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const mesh::Image one = badge_of(i), other = badge_of(j);
            int alone = 0, either = 0;
            for (int y = 0; y < kSide; ++y)
                for (int x = 0; x < kSide; ++x) {
                    const bool is_in_one = one.pixel(x, y)[3] > 250, is_in_other = other.pixel(x, y)[3] > 250;
                    alone += is_in_one != is_in_other;
                    either += is_in_one || is_in_other;
                }
            EXPECT_GT(alone, either / 8) << quarter(i).letter << " and " << quarter(j).letter;
        }
}

TEST(ColourVision, LeavesTheLetterInEachSignReadable) {
    for (const Vision& vision : kVisions)
        for (std::size_t i = 0; i < kQuarters; ++i) {
            const mesh::Image badge = badge_of(i);
            const double ground = tests::luminance(colour_of(vision, badge, i)) + 0.05;
            double most = 1;
            for (int y = kSide / 3; y < kSide * 3 / 4; ++y) {
                const std::uint8_t* pixel = badge.pixel(kSide / 2, y);
                const Colour seen =
                    tests::seen(vision, {tests::linear_of(pixel[0] / 255.0), tests::linear_of(pixel[1] / 255.0),
                                         tests::linear_of(pixel[2] / 255.0)});
                const double letter = tests::luminance(seen) + 0.05;
                most = std::max(most, std::max(letter, ground) / std::min(letter, ground));
            }
            EXPECT_GE(most, 4) << vision.name << " " << quarter(i).letter;  // WCAG 2.2 asks 3 of large letters
        }
}

}  // namespace
}  // namespace quadrat::stage
