// SPDX-License-Identifier: Apache-2.0
#include "stage/miniatures.hpp"

#include <gtest/gtest.h>

namespace quadrat::stage {
namespace {

using namespace std::chrono_literals;
using exhibit::Screen;

exhibit::State seeing(Screen screen, int here, bool was_seen) {
    exhibit::State state;
    state.screen = screen;
    state.family.assign(3, {});
    state.here = here;
    state.family[static_cast<std::size_t>(here)].was_seen = was_seen;
    return state;
}

TEST(Miniatures, AreDueOnceForEachFourWhenTheyHaveSettled) {
    Miniatures miniatures;
    const exhibit::State four = seeing(Screen::Ask, 1, true);
    EXPECT_FALSE(miniatures.due(four, 100ms));
    const auto due = miniatures.due(four, 1s);
    ASSERT_TRUE(due);
    EXPECT_EQ(due->node, 1);
    EXPECT_TRUE(due->is_of_four);
    miniatures.keep(*due, mesh::Image(4, 2, 4));
    EXPECT_FALSE(miniatures.due(four, 1s));
    ASSERT_NE(miniatures.find(1), nullptr);
    EXPECT_EQ(miniatures.find(1)->picture.width, 4);
    EXPECT_EQ(miniatures.find(0), nullptr);
    EXPECT_FALSE(miniatures.due(seeing(Screen::Breed, 0, true), 1s));
}

TEST(Miniatures, ShowAFinaleUntilItsFourAreSeen) {
    Miniatures miniatures;
    const auto finale = miniatures.due(seeing(Screen::Finale, 2, false), 1s);
    ASSERT_TRUE(finale);
    EXPECT_FALSE(finale->is_of_four);
    miniatures.keep(*finale, mesh::Image(4, 2, 4));
    EXPECT_FALSE(miniatures.due(seeing(Screen::Family, 2, false), 1s));
    const int number = miniatures.find(2)->number;
    const auto four = miniatures.due(seeing(Screen::Ask, 2, true), 1s);
    ASSERT_TRUE(four) << "the visit went on from there";
    miniatures.keep(*four, mesh::Image(8, 4, 4));
    EXPECT_NE(miniatures.find(2)->number, number);
    EXPECT_FALSE(miniatures.due(seeing(Screen::Finale, 2, true), 1s)) << "that is of what was held for";
}

TEST(Miniatures, GoWithTheirVisit) {
    Miniatures miniatures;
    miniatures.keep({0, true}, mesh::Image(4, 2, 4));
    EXPECT_FALSE(miniatures.due(exhibit::State{}, 1s));
    EXPECT_EQ(miniatures.find(0), nullptr);
}

}  // namespace
}  // namespace quadrat::stage
