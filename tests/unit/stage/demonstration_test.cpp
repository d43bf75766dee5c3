// SPDX-License-Identifier: Apache-2.0
#include "stage/demonstration.hpp"

#include <gtest/gtest.h>

#include <set>

namespace quadrat::stage {
namespace {

using namespace std::chrono_literals;

TEST(Demonstration, RestsFirstAndMostOfTheTime) {
    for (base::Instant at = 0s; at < 8s; at += 100ms) EXPECT_FALSE(ghost_at(at)) << at.count();
    int shown = 0, all = 0;
    for (base::Instant at = 8s; at < 8s + 400s; at += 100ms, ++all) shown += ghost_at(at) ? 1 : 0;
    EXPECT_LT(shown, all / 3);
    EXPECT_GT(shown, all / 6);
}

TEST(Demonstration, AsksTheThreeQuestionsInTheirOrderAndPressesOneButtonForEach) {
    std::vector<genome::Aspect> asked;
    std::set<std::size_t> pressed;
    float last_press = 0;
    for (base::Instant at = 0s; at < 20s; at += 20ms) {
        const auto ghost = ghost_at(at);
        if (!ghost) continue;
        if (asked.empty() || asked.back() != ghost->question) {
            EXPECT_EQ(ghost->press, 0) << "the question is read first";
            asked.push_back(ghost->question);
            last_press = 0;
        }
        EXPECT_LE(std::abs(ghost->press - last_press), 0.1F) << "it moves softly";
        last_press = ghost->press;
        if (ghost->press == 1) pressed.insert(ghost->button);
    }
    EXPECT_EQ(asked, (std::vector{genome::Aspect::Trees, genome::Aspect::Land, genome::Aspect::Sky}));
    EXPECT_EQ(pressed.size(), 3U);
}

TEST(Demonstration, ComesAndGoesSoftlyAndIsBackLater) {
    EXPECT_NEAR(ghost_at(8001ms)->strength, 0, 0.01F);
    EXPECT_EQ(ghost_at(12s)->strength, 1);
    EXPECT_EQ(ghost_at(12s)->press, ghost_at(52s)->press);
}

}  // namespace
}  // namespace quadrat::stage
