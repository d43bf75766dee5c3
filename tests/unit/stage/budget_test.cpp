// SPDX-License-Identifier: Apache-2.0
#include "stage/budget.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrat::stage {
namespace {

constexpr glm::ivec2 kSize{1000, 500};

std::size_t triangles_at(const render::Detail& detail) {
    return 5'000 + static_cast<std::size_t>(100'000 * std::sqrt(detail.alpha));
}

TEST(Budget, NoneLeavesEverythingAsItIs) {
    const render::Detail detail = detail_within({}, kSize, {0.7F, 0.9F}, triangles_at);
    EXPECT_EQ(detail.alpha, 0.7F);
    EXPECT_EQ(detail.scale, 0.9F);
}

TEST(Budget, OfTrianglesIsKeptAndNearlyUsed) {
    for (const std::size_t triangles : {20'000U, 60'000U, 90'000U}) {
        const render::Detail detail = detail_within({triangles, 0}, kSize, {1, 1}, triangles_at);
        EXPECT_LE(triangles_at(detail), triangles);
        EXPECT_GT(triangles_at(detail), triangles * 97 / 100);
        EXPECT_EQ(detail.scale, 1);
    }
}

TEST(Budget, ThatNothingFitsInEndsAtTheLeast) {
    const render::Detail detail = detail_within({100, 10}, kSize, {1, 1}, triangles_at);
    EXPECT_NEAR(detail.alpha, 0.01F, 1e-4F);
    EXPECT_EQ(detail.scale, 0.25F);
}

TEST(Budget, OfPixelsMakesTheViewsSmaller) {
    const render::Detail detail = detail_within({0, 125'000}, kSize, {1, 1}, triangles_at);
    EXPECT_NEAR(detail.scale, 0.5F, 1e-5F);
    EXPECT_EQ(detail.alpha, 1);
    EXPECT_EQ(detail_within({0, 5'000'000}, kSize, {1, 1}, triangles_at).scale, 1);
}

TEST(BudgetKeeper, IsWithinItAfterAFewFramesAndStaysThere) {
    for (const std::size_t triangles : {20'000U, 60'000U, 90'000U}) {
        BudgetKeeper keeper({triangles, 0}, 1);
        for (int frame = 0; frame < 300; ++frame) {
            const std::size_t drawn = triangles_at(keeper.detail(kSize));
            EXPECT_TRUE(frame <= 12 || drawn <= triangles) << frame << ' ' << drawn;
            EXPECT_TRUE(frame <= 100 || drawn > triangles * 80 / 100) << frame << ' ' << drawn;
            keeper.drew(drawn);
        }
    }
}

TEST(BudgetKeeper, FollowsWhatIsSeenAndIsNeverFinerThanConfigured) {
    BudgetKeeper keeper({50'000, 125'000}, 0.5F);
    EXPECT_EQ(keeper.detail(kSize).scale, 0.5F);
    for (int frame = 0; frame < 100; ++frame) keeper.drew(400'000);  // nothing helps: as coarse as there is
    EXPECT_NEAR(keeper.detail(kSize).alpha, 0.01F, 1e-4F);
    for (int frame = 0; frame < 300; ++frame) keeper.drew(1'000);
    EXPECT_EQ(keeper.detail(kSize).alpha, 0.5F);
}

}  // namespace
}  // namespace quadrat::stage
