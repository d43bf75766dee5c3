// SPDX-License-Identifier: Apache-2.0
// A visit in which sliders are turned instead of four landscapes compared.
#include <gtest/gtest.h>

#include "unit/exhibit/visit_fixture.hpp"

namespace quadrat::exhibit {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

Timings sliding() {
    Timings timings;
    timings.asking = Asking::Sliders;
    timings.sliders = 5;
    timings.rounds = 2;
    return timings;
}

Visitor at_the_sliders() {
    Visitor visitor(sliding());
    visitor.arrive();
    EXPECT_EQ(visitor.screen(), Screen::Slide);
    return visitor;
}

TEST(Slide, ChoosesASliderWithTwoButtonsAllAround) {
    Visitor visitor = at_the_sliders();
    visitor.press(Choice::A);
    EXPECT_EQ(visitor.state().slider, 4);
    visitor.press(Choice::B).press(Choice::B);
    EXPECT_EQ(visitor.state().slider, 1);
    EXPECT_EQ(visitor.wished<TurnSlider>(), nullptr);
    EXPECT_EQ(visitor.state().turns, 0);
}

TEST(Slide, TurnsItWithTheOtherTwoAndGrowsTheLandscapeMeanwhile) {
    Visitor visitor = at_the_sliders();
    visitor.press(Choice::B).send(Pressed{Choice::D});
    EXPECT_EQ(*visitor.wished<TurnSlider>(), (TurnSlider{visitor.state().generation, 1, 1}));
    visitor.send(Pressed{Choice::C});
    EXPECT_EQ(*visitor.wished<TurnSlider>(), (TurnSlider{visitor.state().generation, 1, -1}));
    EXPECT_EQ(visitor.screen(), Screen::Slide) << "nobody waits";
    EXPECT_FALSE(visitor.state().is_ready);
    visitor.grown();
    EXPECT_TRUE(visitor.state().is_ready);
    EXPECT_EQ(visitor.state().turns, 2);
}

TEST(Slide, EndsInTheFinaleAfterAsManyActionsAsAVisitHasAnswers) {
    Visitor visitor = at_the_sliders();
    for (int turn = 0; turn < 5; ++turn) visitor.press(Choice::D).grown();
    EXPECT_EQ(visitor.screen(), Screen::Slide);
    visitor.press(Choice::C);
    EXPECT_NE(visitor.wished<TurnSlider>(), nullptr) << "the last turn counts";
    EXPECT_NE(visitor.wished<GrowFinale>(), nullptr);
    visitor.grown();
    EXPECT_EQ(visitor.screen(), Screen::Finale);
    EXPECT_EQ(visitor.state().rounds, 2);
}

TEST(Slide, BackTakesOneTurnBackToTheFirst) {
    Visitor visitor = at_the_sliders();
    visitor.press(Choice::D).press(Choice::D).press(Choice::Back);
    EXPECT_EQ(visitor.wished<UndoTurn>()->generation, visitor.state().generation);
    visitor.press(Choice::Back);
    EXPECT_EQ(visitor.state().turns, 0);
    const int generation = visitor.state().generation;
    visitor.press(Choice::Back);
    EXPECT_EQ(visitor.state().generation, generation) << "there is nothing left to take back";
}

TEST(Slide, AsksWhetherAnybodyIsThereAndGoesOnWhereItWas) {
    Visitor visitor = at_the_sliders();
    visitor.press(Choice::D).wait(seconds(25));
    ASSERT_EQ(visitor.screen(), Screen::StillThere);
    visitor.press(Choice::C);
    EXPECT_EQ(visitor.screen(), Screen::Slide);
    EXPECT_EQ(visitor.state().turns, 1);
    visitor.wait(seconds(25)).wait(seconds(10));
    EXPECT_EQ(visitor.screen(), Screen::Attract);
}

TEST(Slide, HoldingAButtonEndsInTheFinaleOnceSomethingWasTurned) {
    Visitor visitor = at_the_sliders();
    visitor.hold(Choice::A, seconds(3));
    EXPECT_EQ(visitor.screen(), Screen::Slide);
    visitor.hold(Choice::D, seconds(3));
    EXPECT_NE(visitor.wished<GrowFinale>(), nullptr);
}

TEST(Slide, IsTakenUpAgainWithItsTurns) {
    State state = resumed_sliding(4, seconds(1));
    state = next(state, GenerationReady{state.generation}, seconds(2), sliding()).state;
    EXPECT_EQ(state.screen, Screen::Slide);
    EXPECT_EQ(state.turns, 4);
    EXPECT_EQ(state.rounds, 1);
    const Step step = next(state, Pressed{Choice::Back}, seconds(4), sliding());
    EXPECT_EQ(step.state.turns, 4) << "Back cannot reach what was turned before";
}

}  // namespace
}  // namespace quadrat::exhibit
