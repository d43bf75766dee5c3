// SPDX-License-Identifier: Apache-2.0
#include "exhibit/visit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/exhibit/visit_fixture.hpp"

namespace quadrat::exhibit {
namespace {

using genome::Aspect;
using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(Visit, BeginsInAttractAndPreparesTheFirstFour) {
    const Step step = opening(seconds(5));
    EXPECT_EQ(step.state.screen, Screen::Attract);
    EXPECT_EQ(step.wishes, (std::vector<Wish>{PrepareVisit{step.state.generation}}));
    EXPECT_EQ(next_deadline(step.state, {}), std::nullopt);
}

TEST(Visit, AsksTheFirstQuestionAtTheFirstPressWhenTheFourAreReady) {
    for (const Choice button : {Choice::A, Choice::D, Choice::Back}) {
        Visitor visitor;
        visitor.grown().press(button);
        EXPECT_EQ(visitor.wishes(), (std::vector<Wish>{Acknowledge{button}, BeginVisit{}}));
        EXPECT_EQ(visitor.screen(), Screen::Ask);
        EXPECT_EQ(visitor.state().question, Aspect::Trees);
        EXPECT_EQ(visitor.state().answers, genome::Pick{}) << "the press that wakes is not an answer";
    }
}

TEST(Visit, WaitsInBreedWhenTheVisitorIsFasterThanTheFirstFour) {
    Visitor visitor;
    visitor.press(Choice::B);
    EXPECT_EQ(visitor.screen(), Screen::Breed);
    visitor.send(GenerationReady{visitor.state().generation - 1});
    EXPECT_EQ(visitor.screen(), Screen::Breed) << "a generation nobody waits for";
    visitor.grown();
    EXPECT_EQ(visitor.screen(), Screen::Ask);
}

TEST(Visit, AsksTreesThenLandThenSkyAndBreedsFromTheThreeAnswers) {
    Visitor visitor;
    visitor.arrive().press(Choice::C);
    EXPECT_EQ(visitor.state().question, Aspect::Land);
    EXPECT_EQ(visitor.wishes(), (std::vector<Wish>{Acknowledge{Choice::C}, KeepAnswers{pick_of(2, {}, {})}}));
    visitor.press(Choice::A);
    EXPECT_EQ(visitor.state().question, Aspect::Sky);
    EXPECT_EQ(visitor.wished<KeepAnswers>()->answers, pick_of(2, 0, {}));
    visitor.press(Choice::D);
    EXPECT_EQ(visitor.screen(), Screen::Breed);
    EXPECT_EQ(visitor.wishes(),
              (std::vector<Wish>{Acknowledge{Choice::D}, GrowNext{visitor.state().generation, pick_of(2, 0, 3)}}));
    visitor.grown();
    EXPECT_EQ(visitor.screen(), Screen::Ask);
    EXPECT_EQ(visitor.state().question, Aspect::Trees);
    EXPECT_EQ(visitor.state().answers, genome::Pick{});
    EXPECT_EQ(visitor.state().rounds, 1);
}

TEST(Visit, DoesNotCountASecondPressWithinTheGuardButAcknowledgesIt) {
    Visitor visitor;
    visitor.arrive().press(Choice::A);
    const State before = visitor.state();
    const Step step = next(before, Pressed{Choice::A}, before.since + milliseconds(299), visitor.timings());
    EXPECT_EQ(step.state.answers, before.answers);
    EXPECT_EQ(step.wishes, (std::vector<Wish>{Acknowledge{Choice::A}}));
    const Step later = next(before, Pressed{Choice::A}, before.since + milliseconds(300), visitor.timings());
    EXPECT_EQ(later.state.answers, pick_of(0, 0, {}));
}

TEST(Visit, AcknowledgesPressesDuringBreedWithoutCountingThem) {
    Visitor visitor;
    visitor.arrive().press(Choice::A).press(Choice::A).press(Choice::A);
    ASSERT_EQ(visitor.screen(), Screen::Breed);
    const int generation = visitor.state().generation;
    visitor.press(Choice::D);
    EXPECT_EQ(visitor.wishes(), (std::vector<Wish>{Acknowledge{Choice::D}}));
    visitor.press(Choice::Back);
    EXPECT_EQ(visitor.wishes(), (std::vector<Wish>{Acknowledge{Choice::Back}}));
    EXPECT_EQ(visitor.state().generation, generation);
    visitor.grown();
    EXPECT_EQ(visitor.state().answers, genome::Pick{});
}

TEST(Visit, TakesOneAnswerBackAPressThroughTheRoundsToTheFirst) {
    Visitor visitor;
    visitor.arrive().whole_round(Choice::A, Choice::B, Choice::C).whole_round(Choice::D, Choice::C, Choice::B);
    visitor.press(Choice::D);
    visitor.press(Choice::Back);
    EXPECT_EQ(visitor.state().question, Aspect::Trees);
    EXPECT_EQ(visitor.wished<KeepAnswers>()->answers, genome::Pick{});
    visitor.press(Choice::Back);
    EXPECT_EQ(visitor.screen(), Screen::Breed);
    EXPECT_EQ(visitor.wished<UndoRound>()->answers, pick_of(3, 2, {}));
    visitor.grown();
    EXPECT_EQ(visitor.state().question, Aspect::Sky);
    EXPECT_EQ(visitor.state().answers, pick_of(3, 2, {}));
    EXPECT_EQ(visitor.state().rounds, 1);
    visitor.press(Choice::Back).press(Choice::Back).press(Choice::Back).grown();
    EXPECT_EQ(visitor.state().answers, pick_of(0, 1, {}));
    EXPECT_EQ(visitor.state().rounds, 0);
    visitor.press(Choice::Back).press(Choice::Back);
    const State first = visitor.state();
    visitor.press(Choice::Back);
    EXPECT_EQ(visitor.wishes(), (std::vector<Wish>{Acknowledge{Choice::Back}})) << "nothing is left to take back";
    EXPECT_EQ(visitor.state().question, first.question);
}

TEST(Visit, AsksWhetherAnybodyIsThereAndGoesToAttractWhenNobodyIs) {
    Visitor visitor;
    visitor.arrive().press(Choice::A).wait(seconds(24));
    EXPECT_EQ(visitor.screen(), Screen::Ask);
    visitor.wait(seconds(1));
    EXPECT_EQ(visitor.screen(), Screen::StillThere);
    EXPECT_EQ(countdown_s(visitor.state(), visitor.now(), visitor.timings()), 10);
    visitor.wait(milliseconds(9'999));
    EXPECT_EQ(countdown_s(visitor.state(), visitor.now(), visitor.timings()), 1);
    EXPECT_EQ(visitor.screen(), Screen::StillThere);
    visitor.wait(milliseconds(1));
    EXPECT_EQ(visitor.screen(), Screen::Attract);
    EXPECT_EQ(visitor.wishes(),
              (std::vector<Wish>{EndVisit{Ending::Left, 0}, PrepareVisit{visitor.state().generation}}));
}

TEST(Visit, TakesAPressInStillThereAsAReturnAndNotAsAnAnswer) {
    for (const Choice button : {Choice::B, Choice::Back}) {
        Visitor visitor;
        visitor.arrive().press(Choice::A).wait(seconds(26));
        ASSERT_EQ(visitor.screen(), Screen::StillThere);
        visitor.press(button);
        EXPECT_EQ(visitor.wishes(), (std::vector<Wish>{Acknowledge{button}}));
        EXPECT_EQ(visitor.screen(), Screen::Ask);
        EXPECT_EQ(visitor.state().question, Aspect::Land);
        EXPECT_EQ(visitor.state().answers, pick_of(0, {}, {}));
        visitor.wait(seconds(24));
        EXPECT_EQ(visitor.screen(), Screen::Ask) << "the patience begins anew";
    }
}

TEST(Visit, ShowsTheFinaleAfterItsRoundsAndPreparesTheNextVisitMeanwhile) {
    Visitor visitor;
    visitor.arrive();
    for (int round = 1; round < visitor.timings().rounds; ++round) visitor.whole_round();
    visitor.press(Choice::A).press(Choice::B).press(Choice::C);
    EXPECT_EQ(visitor.wished<GrowNext>(), nullptr) << "four that nobody would see";
    EXPECT_EQ(visitor.wished<GrowFinale>()->answers, pick_of(0, 1, 2));
    visitor.grown();
    EXPECT_EQ(visitor.screen(), Screen::Finale);
    EXPECT_NE(visitor.wished<PrepareVisit>(), nullptr);
    visitor.grown().wait(seconds(20));
    EXPECT_EQ(visitor.screen(), Screen::Attract);
    EXPECT_EQ(visitor.wishes(), (std::vector<Wish>{EndVisit{Ending::Finished, visitor.timings().rounds}}));
    visitor.press(Choice::A);
    EXPECT_EQ(visitor.screen(), Screen::Ask) << "the next visit was ready";
    EXPECT_EQ(visitor.state().rounds, 0);
    EXPECT_TRUE(visitor.state().past_answers.empty()) << "Back cannot reach another visitor's answers";
}

TEST(Visit, LeavesTheFinaleByAPressButNotByAnImpatientOne) {
    Visitor visitor(Timings{.rounds = 1});
    visitor.arrive().press(Choice::A).press(Choice::A).press(Choice::A).grown();
    ASSERT_EQ(visitor.screen(), Screen::Finale);
    visitor.press(Choice::A);
    EXPECT_EQ(visitor.screen(), Screen::Finale);
    visitor.wait(seconds(1)).press(Choice::A);
    EXPECT_EQ(visitor.screen(), Screen::Attract);
}

TEST(Visit, ShowsTheFinaleOnALongPressOnceARoundIsBred) {
    Visitor visitor;
    visitor.arrive().hold(Choice::B, seconds(5));
    EXPECT_EQ(visitor.screen(), Screen::Ask) << "nothing is bred yet";
    visitor.press(Choice::A).press(Choice::A).grown();
    ASSERT_EQ(visitor.state().rounds, 1);
    visitor.hold(Choice::D, milliseconds(1'999));
    EXPECT_EQ(visitor.screen(), Screen::Ask);
    visitor.hold(Choice::D, milliseconds(2'000));
    EXPECT_EQ(visitor.screen(), Screen::Breed);
    EXPECT_EQ(visitor.wished<GrowFinale>()->answers, genome::Pick{}) << "an unfinished round is not learnt";
    visitor.grown();
    EXPECT_EQ(visitor.screen(), Screen::Finale);
}

TEST(Visit, DoesNotTakeHoldingBackForALongPress) {
    Visitor visitor;
    visitor.arrive().whole_round().whole_round().hold(Choice::Back, seconds(3));
    EXPECT_EQ(visitor.wished<GrowFinale>(), nullptr);
}

TEST(Visit, EndsWhenAGenerationNeverComes) {
    Visitor visitor;
    visitor.arrive().press(Choice::A).press(Choice::A).press(Choice::A).wait(seconds(60));
    EXPECT_EQ(visitor.screen(), Screen::Attract);
    EXPECT_EQ(visitor.wished<EndVisit>()->ending, Ending::Stuck);
    EXPECT_NE(visitor.wished<PrepareVisit>(), nullptr);
}

TEST(Visit, WaitsForASlowGenerationAsLongAsItGetsOn) {
    Visitor visitor;
    visitor.arrive().press(Choice::A).press(Choice::A).press(Choice::A);
    for (int part = 0; part < 12; ++part) visitor.wait(seconds(59)).send(Grew{});
    EXPECT_EQ(visitor.screen(), Screen::Breed);
    EXPECT_EQ(visitor.wait(seconds(59)).screen(), Screen::Breed);
    EXPECT_EQ(visitor.wait(seconds(1)).screen(), Screen::Attract) << "and no longer";
}

TEST(Visit, IsTakenUpAgainAtTheFirstQuestionWithoutAnAnswer) {
    for (const auto& [answers, question] :
         std::vector<std::pair<genome::Pick, Aspect>>{{pick_of({}, {}, {}), Aspect::Trees},
                                                      {pick_of(3, {}, {}), Aspect::Land},
                                                      {pick_of(3, 1, {}), Aspect::Sky}}) {
        State state = resumed({pick_of(0, 1, 2), pick_of(3, 3, 3)}, answers, seconds(1));
        EXPECT_EQ(state.screen, Screen::Breed);
        state = next(state, GenerationReady{state.generation}, seconds(2), {}).state;
        EXPECT_EQ(state.screen, Screen::Ask);
        EXPECT_EQ(state.question, question);
        EXPECT_EQ(state.answers, answers);
        EXPECT_EQ(state.rounds, 2);
    }
    EXPECT_EQ(resumed({}, pick_of({}, 1, 2), seconds(1)).answers, genome::Pick{})
        << "no question was answered in order";
}

TEST(Visit, HasAPromptForEveryScreenAndQuestion) {
    State state;
    EXPECT_EQ(prompt_of(state), Prompt::PressAnyButton);
    state.screen = Screen::Ask;
    for (const auto& [aspect, prompt] :
         {std::pair{Aspect::Trees, Prompt::BestTrees}, std::pair{Aspect::Land, Prompt::BestLand},
          std::pair{Aspect::Sky, Prompt::BestSky}}) {
        state.question = aspect;
        EXPECT_EQ(prompt_of(state), prompt);
    }
    state.screen = Screen::Breed;
    EXPECT_EQ(prompt_of(state), Prompt::Growing);
    state.screen = Screen::StillThere;
    EXPECT_EQ(prompt_of(state), Prompt::StillThere);
    EXPECT_EQ(countdown_s(state, seconds(4), {}), 6);
    state.screen = Screen::Finale;
    EXPECT_EQ(prompt_of(state), Prompt::YourLandscape);
    state.screen = Screen::Describe;
    EXPECT_EQ(prompt_of(state), Prompt::WhichWords);
    state.screen = Screen::Slide;
    EXPECT_EQ(prompt_of(state), Prompt::TurnWords);
}

}  // namespace
}  // namespace quadrat::exhibit
