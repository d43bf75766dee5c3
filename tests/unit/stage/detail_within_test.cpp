// SPDX-License-Identifier: Apache-2.0
#include "stage/detail_within.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrat::stage {
namespace {

constexpr glm::ivec2 kSize{1000, 500};

std::size_t triangles_at(const render::Detail& detail) {
    return 5'000 + static_cast<std::size_t>(100'000 * std::sqrt(detail.alpha));
}

TEST(DetailWithin, NoneLeavesEverythingAsItIs) {
    const render::Detail detail = detail_within({}, kSize, {0.7F, 0.9F}, triangles_at);
    EXPECT_EQ(detail.alpha, 0.7F);
    EXPECT_EQ(detail.scale, 0.9F);
}

TEST(DetailWithin, OfTrianglesIsKeptAndNearlyUsed) {
    for (const std::size_t triangles : {20'000U, 60'000U, 90'000U}) {
        const render::Detail detail = detail_within({triangles, 0}, kSize, {1, 1}, triangles_at);
        EXPECT_LE(triangles_at(detail), triangles);
        EXPECT_GT(triangles_at(detail), triangles * 97 / 100);
        EXPECT_EQ(detail.scale, 1);
    }
}

TEST(DetailWithin, ThatNothingFitsInEndsAtTheLeast) {
    const render::Detail detail = detail_within({100, 10}, kSize, {1, 1}, triangles_at);
    EXPECT_NEAR(detail.alpha, 0.01F, 1e-4F);
    EXPECT_EQ(detail.scale, 0.25F);
}

TEST(DetailWithin, OfPixelsMakesTheViewsSmaller) {
    const render::Detail detail = detail_within({0, 125'000}, kSize, {1, 1}, triangles_at);
    EXPECT_NEAR(detail.scale, 0.5F, 1e-5F);
    EXPECT_EQ(detail.alpha, 1);
    EXPECT_EQ(detail_within({0, 5'000'000}, kSize, {1, 1}, triangles_at).scale, 1);
}

}  // namespace
}  // namespace quadrat::stage
