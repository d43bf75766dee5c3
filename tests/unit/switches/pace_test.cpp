// SPDX-License-Identifier: Apache-2.0
#include "switches/pace.hpp"

#include <gtest/gtest.h>

namespace quadrat::switches {
namespace {

using namespace std::chrono_literals;

std::vector<genome::Pick> picks(std::size_t rounds, std::size_t answer) {
    std::vector<genome::Pick> all(rounds);
    for (genome::Pick& pick : all) pick.each.fill(answer);
    return all;
}

Options at_pace(std::chrono::milliseconds pace) {
    Options options;
    options.pace = pace;
    return options;
}

TEST(Pace, OfFourButtonsIsThinkingReactingAndGrowing) {
    const Pace pace = pace_of(picks(40, 2), Buttons::Four, {}, {2s, 500ms, 1s}, base::Seed{1});
    EXPECT_NEAR(60 / pace.rounds_a_minute, 3 * (2 + 0.5) + 1, 0.7);
    EXPECT_DOUBLE_EQ(pace.presses_a_round, 3);
    EXPECT_EQ(pace.missed, 0);
}

TEST(Pace, WithOneButtonFollowsTheMark) {
    const Hand hand{500ms, 300ms, 1s};
    const double slow = pace_of(picks(20, 3), Buttons::One, at_pace(2s), hand, base::Seed{1}).rounds_a_minute;
    const double quick = pace_of(picks(20, 3), Buttons::One, at_pace(1s), hand, base::Seed{1}).rounds_a_minute;
    EXPECT_GT(quick, 1.5 * slow);
    // D is marked after three and a half paces.
    EXPECT_NEAR(60 / slow, 3 * (3.5 * 2 + 0.3) + 1, 3);
    const double near = pace_of(picks(20, 0), Buttons::One, at_pace(2s), hand, base::Seed{1}).rounds_a_minute;
    EXPECT_GT(near, 2 * slow) << "A is marked first";
}

TEST(Pace, WithTwoButtonsAndWithADwellTakesAPressForEachStep) {
    Options all_heard;
    all_heard.quiet = 0ms;
    const Pace two = pace_of(picks(10, 3), Buttons::Two, all_heard, {}, base::Seed{1});
    EXPECT_NEAR(two.presses_a_round, 3 * 4, 0.5);
    Options dwelling = all_heard;
    dwelling.dwell = 1s;
    const Pace dwell = pace_of(picks(10, 3), Buttons::One, dwelling, {}, base::Seed{1});
    EXPECT_GT(dwell.rounds_a_minute, 1);
    EXPECT_NEAR(dwell.presses_a_round, 3 * 4, 0.5);
}

TEST(Pace, ComesToTheEndEvenWhereTheHandIsSlowerThanTheMark) {
    const Pace pace = pace_of(picks(3, 1), Buttons::One, at_pace(700ms), {1s, 900ms, 1s}, base::Seed{2});
    EXPECT_GT(pace.missed, 0);
    EXPECT_GT(pace.rounds_a_minute, 0);
}

}  // namespace
}  // namespace quadrat::switches
