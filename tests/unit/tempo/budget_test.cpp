// SPDX-License-Identifier: Apache-2.0
#include "tempo/budget.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrat::tempo {
namespace {

constexpr double kPixels = 1000.0 * 500;

std::size_t triangles_at(float alpha) { return 5'000 + static_cast<std::size_t>(100'000 * std::sqrt(alpha)); }

TEST(BudgetKeeper, IsWithinItAfterAFewFramesAndStaysThere) {
    for (const std::size_t triangles : {20'000U, 60'000U, 90'000U}) {
        BudgetKeeper keeper({triangles, 0}, 1);
        for (int frame = 0; frame < 300; ++frame) {
            const std::size_t drawn = triangles_at(keeper.fineness(kPixels).alpha);
            EXPECT_TRUE(frame <= 12 || drawn <= triangles) << frame << ' ' << drawn;
            EXPECT_TRUE(frame <= 100 || drawn > triangles * 80 / 100) << frame << ' ' << drawn;
            keeper.drew(drawn);
        }
    }
}

TEST(BudgetKeeper, FollowsWhatIsSeenAndIsNeverFinerThanConfigured) {
    BudgetKeeper keeper({50'000, 125'000}, 0.5F);
    EXPECT_EQ(keeper.fineness(kPixels).scale, 0.5F);
    for (int frame = 0; frame < 100; ++frame) keeper.drew(400'000);  // nothing helps: as coarse as there is
    EXPECT_NEAR(keeper.fineness(kPixels).alpha, 0.01F, 1e-4F);
    for (int frame = 0; frame < 300; ++frame) keeper.drew(1'000);
    EXPECT_EQ(keeper.fineness(kPixels).alpha, 0.5F);
}

}  // namespace
}  // namespace quadrat::tempo
