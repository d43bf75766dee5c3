// SPDX-License-Identifier: Apache-2.0
// What holds of every visit with one button or two, whatever is pressed and whenever.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/seed.hpp"
#include "unit/switches/player.hpp"

namespace quadrat::switches {
namespace {

using std::chrono::milliseconds;

Options any_options(base::RandomStream& chance) {
    Options options;
    options.always = static_cast<Buttons>(chance.below(3));
    options.held = static_cast<Buttons>(1 + chance.below(2));
    options.hold = milliseconds(chance.below(2) * 3000);
    options.pace = milliseconds(300 + chance.below(3000));
    options.times_round = static_cast<int>(chance.below(4));
    options.begins_by_itself = chance.below(2) == 0;
    options.dwell = milliseconds(chance.below(2) * 1500);
    options.quiet = milliseconds(chance.below(2) * 400);
    return options;
}

class AnySwitches : public testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Seeds, AnySwitches, testing::Range<std::uint64_t>(1, 25));

void expect_consistent(const Player& player) {
    const State& state = player.state();
    if (state.marked) {
        ASSERT_NE(state.buttons, Buttons::Four);
        ASSERT_TRUE(state.screen == exhibit::Screen::Ask || state.screen == exhibit::Screen::Describe);
    }
    if (state.hold) {
        ASSERT_EQ(state.buttons, Buttons::Four);
        ASSERT_TRUE(state.is_down.at(static_cast<std::size_t>(state.hold->button)));
    }
    const bool goes_by_itself = state.buttons == Buttons::One && player.options().dwell.count() == 0;
    if (goes_by_itself && player.options().times_round > 0) {
        ASSERT_LE(state.times_round, player.options().times_round);
    }
    if (player.screen() == exhibit::Screen::Attract && state.screen == exhibit::Screen::Attract) {
        ASSERT_EQ(state.buttons, player.options().always);
    }
    for (std::size_t i = 0; i < state.told.size(); ++i) {
        ASSERT_TRUE(!state.told[i] || state.is_down[i]);
    }
}

// Random hands press random buttons; each is let go again before it is pressed anew, as sources promise.
TEST_P(AnySwitches, TellTheVisitPressesThatAlternateWithReleasesAndStayConsistent) {
    base::RandomStream chance(base::Seed{GetParam()});
    exhibit::Timings timings;
    timings.rounds = 2;
    timings.describe_every = 1;
    Player player(any_options(chance), timings);
    std::array<bool, 5> is_down{};
    for (int i = 0; i < 20'000; ++i) {
        player.pass(milliseconds(chance.below(chance.below(10) == 0 ? 9'000 : 500)));
        player.tick();
        const std::size_t button = chance.below(5);
        if (is_down[button])
            player.up(static_cast<Choice>(button));
        else if (chance.below(3) != 0)
            player.down(static_cast<Choice>(button));
        else
            continue;
        is_down[button] = !is_down[button];
        expect_consistent(player);
        if (testing::Test::HasFatalFailure()) FAIL() << "event " << i;
    }
    for (std::size_t button = 0; button < is_down.size(); ++button)
        if (is_down[button]) player.up(static_cast<Choice>(button));
    std::size_t pressed = 0, released = 0;
    for (const exhibit::Event& event : player.told) {
        pressed += std::holds_alternative<exhibit::Pressed>(event);
        released += std::holds_alternative<exhibit::Released>(event);
        ASSERT_LE(released, pressed);
        ASSERT_FALSE(std::holds_alternative<exhibit::Tick>(event));
    }
    EXPECT_EQ(pressed, released) << "nothing is held for ever";
    EXPECT_GT(pressed, 100U);
}

TEST_P(AnySwitches, ChangeAtTheirDeadlineAndNotANanosecondBefore) {
    base::RandomStream chance(base::Seed{GetParam()});
    Player player(any_options(chance));
    int deadlines = 0;
    for (int i = 0; i < 3'000; ++i) {
        player.pass(milliseconds(chance.below(700)));
        player.tick();
        player.tick();
        const Beside beside{player.visit(), player.can_go_back(), Instant{0},
                            exhibit::meant_by(player.visit(), player.timings())};
        const auto due = next_deadline(player.state(), beside, player.options());
        const Step again = next(player.state(), exhibit::Tick{}, beside, player.now(), player.options());
        ASSERT_TRUE(again.state == player.state() && again.events.empty()) << "while time stands still nothing changes";
        if (due && *due > player.now()) {
            const Step early = next(player.state(), exhibit::Tick{}, beside, *due - Instant{1}, player.options());
            ASSERT_TRUE(early.state == player.state() && early.events.empty());
            const Step late = next(player.state(), exhibit::Tick{}, beside, *due, player.options());
            ASSERT_FALSE(late.state == player.state());
            ++deadlines;
        }
        const auto button = static_cast<Choice>(chance.below(5));
        if (chance.below(3) == 0) player.press(button);
    }
    if (player.options().always == Buttons::One && player.options().dwell.count() == 0) {
        EXPECT_GT(deadlines, 100);
    }
}

// Whoever waits for what they want, and presses then, gets that and nothing else.
TEST_P(AnySwitches, WhatIsMarkedWhenItIsPressedIsTaken) {
    base::RandomStream chance(base::Seed{GetParam()});
    Options options = any_options(chance);
    options.always = Buttons::One;
    options.dwell = milliseconds(0);
    exhibit::Timings timings;
    timings.rounds = 50;
    Player player(options, timings);
    player.press(Choice::A).wait(milliseconds(500));
    for (int i = 0; i < 30; ++i) {
        player.wait(milliseconds(500));
        if (!player.marked()) player.press(Choice::C).wait(milliseconds(500));
        const auto wanted = static_cast<Choice>(chance.below(4));
        player.until_marked(wanted);
        if (player.marked() != wanted) player.press(Choice::C).wait(milliseconds(500)).until_marked(wanted);
        ASSERT_EQ(player.marked(), wanted);
        player.press(static_cast<Choice>(chance.below(5)));
        const auto& told = player.told[player.told.size() - 2];
        ASSERT_EQ(std::get<exhibit::Pressed>(told).button, wanted);
    }
}

}  // namespace
}  // namespace quadrat::switches
