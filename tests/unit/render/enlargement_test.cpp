// SPDX-License-Identifier: Apache-2.0
#include "render/gl/enlargement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace quadrat::render::gl {
namespace {

std::vector<std::uint32_t> picture_of(glm::ivec2 size) {
    std::mt19937 random(21);
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(size.x * size.y));
    for (std::uint32_t& pixel : pixels) pixel = static_cast<std::uint32_t>(random());
    return pixels;
}

// Every so many rows of it, then the ones after those.
std::vector<std::uint32_t> written(Enlargement& enlargement, const std::vector<std::uint32_t>& picture, glm::ivec2 to,
                                   int stride = 1) {
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(to.x * to.y));
    enlargement.begin(picture);
    for (int first = 0; first < stride; ++first) {
        for (int y = first; y < to.y; y += stride)
            enlargement.write(y, std::span{pixels}.subspan(static_cast<std::size_t>(y * to.x)));
    }
    return pixels;
}

std::vector<std::uint32_t> enlarged(const std::vector<std::uint32_t>& picture, glm::ivec2 from, glm::ivec2 to) {
    Enlargement enlargement(from, to);
    return written(enlargement, picture, to);
}

double byte_of(std::uint32_t pixel, int byte) { return (pixel >> (8U * static_cast<unsigned>(byte))) & 255U; }

// The two pixels about this place of a side, and how much of the second.
struct Place {
    int before;
    double share;
};
Place place_of(int at, int from, int to) {
    const double place = to > 1 ? static_cast<double>(at) * (from - 1) / (to - 1) : 0;
    const int before = std::min(static_cast<int>(place), from - 2);
    return {before, place - before};
}

TEST(Enlargement, IsTheBilinearPicture) {
    constexpr std::pair<glm::ivec2, glm::ivec2> kSizes[] = {
        {{2, 2}, {2, 2}}, {{2, 2}, {37, 19}}, {{17, 5}, {64, 20}}, {{32, 18}, {64, 36}}, {{51, 29}, {64, 36}}};
    for (const auto& sizes : kSizes) {
        const glm::ivec2 from = sizes.first;
        const glm::ivec2 to = sizes.second;
        const auto picture = picture_of(from);
        const auto pixels = enlarged(picture, from, to);
        for (int i = 0; i < to.x * to.y * 4; ++i) {
            const int x = i / 4 % to.x;
            const int y = i / 4 / to.x;
            const Place across = place_of(x, from.x, to.x);
            const Place down = place_of(y, from.y, to.y);
            const auto row = [&](int at) {
                const std::uint32_t* pair = &picture[static_cast<std::size_t>(at * from.x + across.before)];
                return std::lerp(byte_of(pair[0], i % 4), byte_of(pair[1], i % 4), across.share);
            };
            const double expected = std::lerp(row(down.before), row(down.before + 1), down.share);
            // Twice a step of 1/256 of up to 255, at most half of it wrong, and twice half a byte.
            ASSERT_NEAR(byte_of(pixels[static_cast<std::size_t>(y * to.x + x)], i % 4), expected, 2)
                << x << ", " << y << " of " << to.x << "x" << to.y;
        }
    }
}

TEST(Enlargement, KeepsCornersAndWhatIsNotEnlarged) {
    constexpr glm::ivec2 kSize{33, 7};
    const auto picture = picture_of(kSize);
    EXPECT_EQ(enlarged(picture, kSize, kSize), picture);
    const auto large = enlarged(picture, kSize, {130, 28});
    EXPECT_EQ(large.front(), picture.front());
    EXPECT_EQ(large[129], picture[32]);
    EXPECT_EQ(large.back(), picture.back());
}

TEST(Enlargement, IsTheSameInAnyOrderOfRowsAndWithEveryPicture) {
    constexpr glm::ivec2 kFrom{40, 23};
    constexpr glm::ivec2 kTo{64, 45};
    const auto picture = picture_of(kFrom);
    const auto whole = enlarged(picture, kFrom, kTo);
    Enlargement enlargement(kFrom, kTo);
    for (const int stride : {1, 7, 16}) {
        EXPECT_EQ(written(enlargement, picture, kTo, stride), whole) << stride;
        const std::vector<std::uint32_t> turned(picture.rbegin(), picture.rend());
        EXPECT_NE(written(enlargement, turned, kTo, stride), whole) << stride;
    }
}

}  // namespace
}  // namespace quadrat::render::gl
