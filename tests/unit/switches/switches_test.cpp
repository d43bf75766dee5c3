// SPDX-License-Identifier: Apache-2.0
#include "switches/switches.hpp"

#include <gtest/gtest.h>

#include "unit/switches/player.hpp"

namespace quadrat::switches {
namespace {

using exhibit::Screen;
using std::chrono::milliseconds;
using std::chrono::seconds;

Options with(Buttons buttons) {
    Options options;
    options.always = buttons;
    return options;
}

exhibit::Timings short_visit(int describe_words = 0) {
    exhibit::Timings timings;
    timings.rounds = 2;
    timings.describe_words = describe_words;
    timings.describe_every = 1;
    return timings;
}

std::vector<genome::Pick> rounds_of(const Player& player) {
    std::vector<genome::Pick> rounds;
    for (const auto& wish : all_of<exhibit::GrowNext>(player.wishes)) rounds.push_back(wish.answers);
    for (const auto& wish : all_of<exhibit::GrowFinale>(player.wishes)) rounds.push_back(wish.answers);
    return rounds;
}

genome::Pick picks(std::size_t trees, std::size_t land, std::size_t sky) {
    genome::Pick pick;
    pick.each = {trees, land, sky};
    return pick;
}

TEST(FourButtons, ArePlainWires) {
    Options options;
    options.hold = milliseconds(0);
    Player player(options);
    player.press(Choice::Back).wait(seconds(1)).down(Choice::C).down(Choice::A).up(Choice::C);
    ASSERT_EQ(player.told.size(), 5U);
    EXPECT_EQ(std::get<exhibit::Pressed>(player.told[0]).button, Choice::Back);
    EXPECT_EQ(std::get<exhibit::Pressed>(player.told[2]).button, Choice::C);
    EXPECT_EQ(std::get<exhibit::Pressed>(player.told[3]).button, Choice::A);
    EXPECT_EQ(std::get<exhibit::Released>(player.told[4]).button, Choice::C);
    EXPECT_FALSE(player.marked());
}

TEST(OneButton, PlaysAWholeVisitWithItsPicksItsBackAndItsDescribe) {
    Player player(with(Buttons::One), short_visit(2));
    player.arrive();
    ASSERT_EQ(player.screen(), Screen::Ask);
    player.take(Choice::C).take(Choice::B);
    player.take(Choice::Back);  // the land after all
    EXPECT_EQ(player.visit().question, genome::Aspect::Land);
    player.take(Choice::D).take(Choice::A);
    EXPECT_EQ(player.visit().rounds, 1);
    player.take(Choice::A).take(Choice::A).take(Choice::B);
    ASSERT_EQ(player.screen(), Screen::Finale);
    EXPECT_FALSE(player.marked()) << "any press will do";
    EXPECT_EQ(rounds_of(player), (std::vector{picks(2, 3, 0), picks(0, 0, 1)}));
    player.wait(seconds(3)).press(Choice::B);
    ASSERT_EQ(player.screen(), Screen::Describe);
    player.take(Choice::D).take(Choice::Back);
    EXPECT_EQ(all_of<exhibit::KeepWord>(player.wishes), (std::vector{exhibit::KeepWord{0, 3}}));
    EXPECT_EQ(all_of<exhibit::EndVisit>(player.wishes), (std::vector{exhibit::EndVisit{exhibit::Ending::Finished, 2}}));
    EXPECT_EQ(player.screen(), Screen::Attract);
}

TEST(OneButton, IsNotAskedForByAButtonThatIsStuck) {
    Player player(Options{});
    player.arrive().down(Choice::C).wait(seconds(10));
    ASSERT_EQ(player.state().buttons, Buttons::One);
    ASSERT_EQ(player.timings().patience, exhibit::Timings{}.patience * 3);
    player.wait(seconds(51)).up(Choice::C);  // as a panel lets go of it for good
    EXPECT_EQ(player.state().buttons, Buttons::Four);
    EXPECT_FALSE(player.marked());
    player.wait(milliseconds(20));
    EXPECT_EQ(player.screen(), Screen::StillThere) << "nobody has stirred for a minute";
    player.press(Choice::A).down(Choice::B).wait(seconds(10)).up(Choice::B);
    EXPECT_EQ(player.state().buttons, Buttons::One) << "who asks lets go";
}

// What was held was let go for them, as when staff take over; later presses of that button are presses.
TEST(OneButton, IsStillPlayedWithOnceAHoldWasLetGo) {
    Player player(Options{});
    player.arrive().down(Choice::C).wait(seconds(10));
    player.let_go().wait(seconds(31)).press(Choice::C);
    EXPECT_EQ(player.state().buttons, Buttons::One);
}

TEST(OneButton, MayBeAskedForByAHoldThatIsLongerThanNobodys) {
    Options options;
    options.hold = kNobodysHold + seconds(5);
    exhibit::Timings timings;
    timings.patience = seconds(60);
    Player player(options, timings);
    player.arrive().hold(Choice::C, options.hold + seconds(1));
    EXPECT_EQ(player.state().buttons, Buttons::One);
}

TEST(OneButton, IsAnyOfThem) {
    for (const Choice button : {Choice::A, Choice::D, Choice::Back}) {
        Player player(with(Buttons::One));
        player.press(button).wait(milliseconds(600)).until_marked(Choice::B).press(button);
        EXPECT_EQ(player.visit().answers[genome::Aspect::Trees], 1U);
    }
}

TEST(OneButton, TheMarkGoesRoundAtItsPaceAndLongerOnTheFirst) {
    Options options = with(Buttons::One);
    options.pace = seconds(2);
    Player player(options);
    player.press(Choice::B).wait(milliseconds(1));
    const auto stays = [&] {
        const Instant since = player.now();
        for (const auto marked = player.marked(); player.marked() == marked;) player.wait(milliseconds(20));
        return player.now() - since;
    };
    std::vector<std::optional<Choice>> seen;
    for (const milliseconds expected :
         {milliseconds(3000), milliseconds(2000), milliseconds(2000), milliseconds(2000)}) {
        seen.push_back(player.marked());
        EXPECT_NEAR(static_cast<double>(stays().count()), static_cast<double>(Instant(expected).count()), 1.1e8);
    }
    EXPECT_EQ(seen, (std::vector<std::optional<Choice>>{Choice::A, Choice::B, Choice::C, Choice::D}));
    EXPECT_EQ(player.marked(), Choice::A) << "there is nothing to go back to yet, so Back is not among them";
}

TEST(OneButton, TheMarkWaitsUntilWhatItMarksHasBeenSaid) {
    exhibit::State visit;
    visit.screen = Screen::Ask;
    visit.since = seconds(10);
    Options dwelling = with(Buttons::One);
    dwelling.dwell = seconds(2);
    for (const Options& options : {with(Buttons::One), dwelling}) {
        State state = next({}, exhibit::Tick{}, {visit}, seconds(10), options).state;
        if (!state.marked) {
            state = next(state, exhibit::Pressed{Choice::B}, {visit}, seconds(11), options).state;
            state = next(state, exhibit::Released{Choice::B}, {visit}, seconds(11), options).state;
        }
        const auto silent = next_deadline(state, {visit}, options);
        ASSERT_TRUE(silent);
        const auto spoken = next_deadline(state, {visit, false, seconds(17)}, options);
        EXPECT_EQ(spoken, Instant(seconds(17)) + (*silent - state.marked_since));
        EXPECT_EQ(next_deadline(state, {visit, false, seconds(4)}, options), silent) << "said long ago";
    }
}

TEST(OneButton, NeverMarksWhatStandsForNothing) {
    exhibit::Timings speaking = short_visit(1);
    speaking.languages = 3;
    Player player(with(Buttons::One), speaking);
    player.press(Choice::B);
    ASSERT_EQ(player.screen(), Screen::Language);
    std::vector<Choice> marked;
    for (int frames = 0; frames < 600; ++frames) {
        player.wait(std::chrono::milliseconds(20));
        if (player.marked() && (marked.empty() || marked.back() != *player.marked()))
            marked.push_back(*player.marked());
    }
    ASSERT_GE(marked.size(), 5U);
    EXPECT_EQ((std::vector(marked.begin(), marked.begin() + 5)),
              (std::vector{Choice::A, Choice::B, Choice::C, Choice::A, Choice::B}))
        << "D is no language";
}

TEST(OneButton, MarksBackToo) {
    Player player(with(Buttons::One));
    player.arrive().take(Choice::B).until_marked(Choice::Back).until_marked(Choice::A);
    EXPECT_EQ(player.marked(), Choice::A);
    EXPECT_EQ(player.state().times_round, 1);
}

TEST(OneButton, TheMarkRestsAfterItsTimesRoundUntilAPressThatChoosesNothing) {
    Options options = with(Buttons::One);
    options.times_round = 2;
    options.pace = seconds(1);
    exhibit::Timings timings;
    timings.patience = seconds(60);
    Player player(options, timings);
    player.arrive().wait(seconds(12));
    ASSERT_FALSE(player.marked());
    player.press(Choice::A);
    EXPECT_EQ(player.marked(), Choice::A);
    EXPECT_FALSE(player.visit().answers[genome::Aspect::Trees]);
    options.times_round = 0;
    Player forever(options, timings);
    for (forever.arrive(); forever.screen() == Screen::Ask; forever.wait(seconds(1))) ASSERT_TRUE(forever.marked());
}

TEST(OneButton, BeginsByAPressWhereTheSiteWantsIt) {
    Options options = with(Buttons::One);
    options.begins_by_itself = false;
    Player player(options);
    player.arrive().wait(seconds(9));
    EXPECT_FALSE(player.marked());
    player.press(Choice::C);
    EXPECT_EQ(player.marked(), Choice::A);
    player.take(Choice::A);
    EXPECT_EQ(player.visit().question, genome::Aspect::Land);
    EXPECT_FALSE(player.marked()) << "the next question too";
}

TEST(OneButton, TheMarkStandsStillWhileAButtonIsDownAndASlowHandTakesWhatItSaw) {
    Player player(with(Buttons::One));
    player.arrive().until_marked(Choice::B).wait(milliseconds(1990)).down(Choice::A);
    player.wait(milliseconds(900));
    EXPECT_EQ(player.visit().answers[genome::Aspect::Trees], 1U) << "the press counts when it is made";
    EXPECT_EQ(player.marked(), Choice::A) << "of the next question, and it waits";
    player.wait(seconds(4));
    EXPECT_EQ(player.marked(), Choice::A);
    player.up(Choice::A).wait(milliseconds(2900));
    EXPECT_EQ(player.marked(), Choice::A);
    player.wait(milliseconds(200));
    EXPECT_EQ(player.marked(), Choice::B);
}

TEST(OneButton, HearsATremblingHandOnce) {
    Options options = with(Buttons::One);
    options.quiet = milliseconds(800);
    Player player(options);
    player.arrive().wait(seconds(1)).until_marked(Choice::C);
    for (int i = 0; i < 4; ++i) player.hold(Choice::A, milliseconds(60)).wait(milliseconds(100));
    EXPECT_EQ(player.visit().question, genome::Aspect::Land) << "one answer, to one question";
}

TEST(OneButton, WithADwellEveryPressGoesOnAndRestTakes) {
    Options options = with(Buttons::One);
    options.dwell = seconds(3);
    Player player(options);
    player.arrive().wait(seconds(8));
    EXPECT_FALSE(player.marked()) << "nothing is taken that nobody marked";
    for (int i = 0; i < 3; ++i) player.press(Choice::D).wait(milliseconds(700));
    EXPECT_EQ(player.marked(), Choice::C);
    player.wait(milliseconds(2200));
    EXPECT_FALSE(player.visit().answers[genome::Aspect::Trees]);
    player.wait(milliseconds(300));
    EXPECT_EQ(player.visit().answers[genome::Aspect::Trees], 2U);
    player.wait(seconds(9));
    EXPECT_EQ(player.visit().question, genome::Aspect::Land) << "one rest is one choice";
}

TEST(TwoButtons, PlayAWholeVisitAsFastAsTheyLike) {
    Player player(with(Buttons::Two), short_visit());
    const auto take = [&](int steps) {
        player.wait(milliseconds(500));
        for (int i = 0; i < steps; ++i) player.press(Choice::A).wait(milliseconds(450));
        player.press(Choice::B);
    };
    player.arrive();
    take(2);
    take(1);
    take(4);  // Back
    EXPECT_EQ(player.visit().question, genome::Aspect::Land);
    take(3);
    take(0);
    take(0);
    take(5);  // round, and A again
    take(1);
    EXPECT_EQ(player.screen(), Screen::Finale);
    EXPECT_EQ(rounds_of(player), (std::vector{picks(2, 3, 0), picks(0, 0, 1)}));
}

TEST(TwoButtons, NothingIsChosenByWaiting) {
    exhibit::Timings timings;
    timings.patience = seconds(200);
    Player player(with(Buttons::Two), timings);
    player.arrive().press(Choice::A).wait(seconds(100));
    EXPECT_EQ(player.marked(), Choice::B) << "nor does it go on";
    EXPECT_EQ(player.visit().question, genome::Aspect::Trees);
}

TEST(TwoButtons, WithADwellOneOfThemIsEnough) {
    Options options = with(Buttons::Two);
    options.dwell = seconds(2);
    Player player(options);
    player.arrive().press(Choice::A).wait(milliseconds(500)).press(Choice::A).wait(milliseconds(2200));
    EXPECT_EQ(player.visit().answers[genome::Aspect::Trees], 1U);
}

TEST(Holding, AsksForOneButtonUntilTheVisitEnds) {
    Player player(Options{}, short_visit());
    player.down(Choice::C).wait(milliseconds(3900));
    ASSERT_EQ(player.screen(), Screen::Ask) << "the press is heard at once, whatever comes of it";
    EXPECT_EQ(player.state().buttons, Buttons::Four);
    EXPECT_NEAR(hold_share(player.state(), player.now(), player.options()), 0.975F, 0.01F);
    player.wait(milliseconds(200));
    EXPECT_EQ(player.state().buttons, Buttons::One);
    EXPECT_EQ(player.marked(), Choice::A);
    player.up(Choice::C).take(Choice::B).take(Choice::B).take(Choice::B).take(Choice::B).take(Choice::B).take(
        Choice::B);
    ASSERT_EQ(player.screen(), Screen::Finale);
    player.wait(seconds(61));
    ASSERT_EQ(player.screen(), Screen::Attract);
    EXPECT_EQ(player.state().buttons, Buttons::Four);
    player.press(Choice::A).wait(seconds(1)).press(Choice::D);
    EXPECT_EQ(player.visit().answers[genome::Aspect::Trees], 3U) << "the next visitor has four";
}

TEST(Holding, AsksForTwoWhereTheSiteSaysSo) {
    Options options;
    options.held = Buttons::Two;
    Player player(options);
    player.hold(Choice::A, seconds(5));
    EXPECT_EQ(player.state().buttons, Buttons::Two);
}

TEST(Holding, AnswersTheFirstQuestionsToo) {
    Player player(Options{});
    player.press(Choice::A).wait(seconds(1)).hold(Choice::D, seconds(5));
    EXPECT_EQ(player.state().buttons, Buttons::One);
    EXPECT_EQ(player.visit().answers[genome::Aspect::Trees], 3U);
    EXPECT_EQ(player.screen(), Screen::Ask);
}

TEST(Holding, StaysALongPressOnceThereIsAFinaleToAskFor) {
    Player player(Options{});
    player.press(Choice::A).wait(seconds(1));
    for (int i = 0; i < 3; ++i) player.press(Choice::B).wait(seconds(1));
    player.hold(Choice::B, seconds(8));
    EXPECT_EQ(player.screen(), Screen::Finale);
    EXPECT_EQ(player.state().buttons, Buttons::Four);
}

TEST(Holding, TwoButtonsAtOnceOrAShortHoldAskForNothing) {
    Player player(Options{});
    player.down(Choice::A).down(Choice::Back).wait(seconds(9)).up(Choice::A).up(Choice::Back);
    player.hold(Choice::B, milliseconds(3000));
    EXPECT_EQ(player.state().buttons, Buttons::Four);
    Options never;
    never.hold = milliseconds(0);
    Player other(never);
    other.hold(Choice::A, seconds(9));
    EXPECT_EQ(other.state().buttons, Buttons::Four);
}

TEST(Patience, IsLongerWithFewerButtonsAndEndsWithThem) {
    exhibit::Timings usual;
    const exhibit::Timings longer = patient(usual, 3);
    EXPECT_EQ(longer.patience, 3 * usual.patience);
    EXPECT_EQ(longer.countdown, 3 * usual.countdown);
    EXPECT_EQ(longer.describe, 3 * usual.describe);
    EXPECT_EQ(longer.finale, 3 * usual.finale);
    EXPECT_EQ(longer.long_press, 3 * usual.long_press);
    EXPECT_EQ(longer.press_guard, usual.press_guard);
    EXPECT_EQ(longer.rounds, usual.rounds);
    Player player(with(Buttons::One));
    player.arrive().wait(seconds(70));
    EXPECT_EQ(player.screen(), Screen::Ask);
    player.wait(seconds(6));
    EXPECT_EQ(player.screen(), Screen::StillThere);
    player.press(Choice::C);
    EXPECT_EQ(player.screen(), Screen::Ask);
    EXPECT_EQ(player.marked(), Choice::A) << "from the beginning";
}

TEST(Patience, BeginsAnewWithEveryPressThatMovesTheMark) {
    Player player(with(Buttons::Two));
    player.arrive();
    for (int i = 0; i < 12; ++i) player.wait(seconds(20)).press(Choice::A);
    EXPECT_EQ(player.screen(), Screen::Ask) << "four minutes of looking";
    EXPECT_EQ(player.visit().question, genome::Aspect::Trees);
}

TEST(LetGo, ForgetsWhatIsHeldAndTellsTheVisit) {
    Player player(Options{});
    player.down(Choice::B);
    const Step step = let_go(player.state());
    ASSERT_EQ(step.events.size(), 1U);
    EXPECT_EQ(std::get<exhibit::Released>(step.events[0]).button, Choice::B);
    EXPECT_FALSE(step.state.hold);
    EXPECT_TRUE(let_go(step.state).events.empty());
}

}  // namespace
}  // namespace quadrat::switches
