// SPDX-License-Identifier: Apache-2.0
// A visit suits its visitor: it is shorter where picks agree and longer where they change, and invites groups to take
// turns.
#include <gtest/gtest.h>

#include "visit_fixture.hpp"

namespace quadrat::exhibit {
namespace {

using namespace std::chrono_literals;

Timings suiting() {
    Timings timings;
    timings.rounds = 5;
    timings.rounds_early = 2;
    timings.rounds_more = 2;
    return timings;
}

Visitor& round(Visitor& visitor, bool is_narrow, bool is_changing) {
    visitor.press(Choice::A).press(Choice::A).press(Choice::A);
    return visitor.send(Believed{is_narrow, is_changing}).grown();
}

TEST(Suiting, ComesToItsFinaleAsSoonAsPicksAgreeButNotBefore) {
    Visitor visitor(suiting());
    visitor.arrive();
    round(visitor, true, false);
    round(visitor, true, false);
    EXPECT_EQ(visitor.screen(), Screen::Ask) << "two rounds early, at most";
    visitor.press(Choice::A).press(Choice::A).press(Choice::A);
    ASSERT_NE(visitor.wished<GrowNext>(), nullptr);
    visitor.send(Believed{true, false});
    const auto* finale = visitor.wished<GrowFinale>();
    ASSERT_NE(finale, nullptr);
    EXPECT_EQ(finale->answers, genome::Pick{}) << "they were learnt";
    EXPECT_EQ(visitor.grown().screen(), Screen::Finale);
    EXPECT_EQ(visitor.state().rounds, 3);
}

TEST(Suiting, ComesToItInTimeWherePicksNeitherAgreeNorChange) {
    Visitor visitor(suiting());
    visitor.arrive();
    for (int i = 0; i < 4; ++i) EXPECT_EQ(round(visitor, false, false).screen(), Screen::Ask);
    EXPECT_EQ(round(visitor, false, false).screen(), Screen::Finale);
}

TEST(Suiting, GoesOnWherePicksChangeButNotForEver) {
    Visitor visitor(suiting());
    visitor.arrive();
    for (int i = 0; i < 6; ++i) EXPECT_EQ(round(visitor, false, true).screen(), Screen::Ask);
    visitor.press(Choice::A).press(Choice::A).press(Choice::A);
    EXPECT_NE(visitor.wished<GrowFinale>(), nullptr);
    EXPECT_EQ(visitor.grown().state().rounds, 7);
}

TEST(Suiting, TakesNoNoticeOfWhatIsBelievedAtAnyOtherTime) {
    Visitor visitor(suiting());
    visitor.send(Believed{true, false});
    EXPECT_EQ(visitor.screen(), Screen::Attract);
    visitor.arrive();
    for (int i = 0; i < 3; ++i) round(visitor, false, false);
    visitor.send(Believed{true, false});
    EXPECT_EQ(visitor.screen(), Screen::Ask);
}

TEST(Turns, AreOfferedWhereHandsMeetOrAlways) {
    Timings timings;
    timings.turns = TakingTurns::Found;
    Visitor visitor(timings);
    visitor.arrive();
    EXPECT_FALSE(takes_turns(visitor.state(), timings));
    visitor.press(Choice::A).press(Choice::B);
    EXPECT_FALSE(takes_turns(visitor.state(), timings)) << "one hand after the other";
    for (int i = 0; i < kCrossingsOfAGroup; ++i) {
        visitor.press(Choice::Back);
        visitor.send(Pressed{Choice::C});
        visitor.send(Pressed{Choice::C}).send(Released{Choice::C});
    }
    EXPECT_TRUE(takes_turns(visitor.state(), timings));
    timings.turns = TakingTurns::Never;
    EXPECT_FALSE(takes_turns(visitor.state(), timings));
    timings.turns = TakingTurns::Always;
    EXPECT_TRUE(takes_turns(State{}, timings));
    visitor.wait(60s).wait(60s);
    ASSERT_EQ(visitor.screen(), Screen::Attract);
    EXPECT_EQ(visitor.state().crossings, 0) << "the next visitor comes alone";
}

TEST(BreedingOn, FromWhatHangsIsWishedByItsButtonAlone) {
    Timings timings;
    timings.can_breed_on = true;
    Visitor visitor(timings);
    visitor.grown().press(Choice::D);
    ASSERT_NE(visitor.wished<BreedOn>(), nullptr);
    EXPECT_EQ(visitor.wished<BreedOn>()->generation, visitor.state().generation);
    EXPECT_EQ(visitor.grown().screen(), Screen::Ask);
    EXPECT_TRUE(visitor.state().breeds_on);
    EXPECT_EQ(visitor.state().rounds, 0);
    visitor.wait(60s).wait(60s).grown().press(Choice::A);
    EXPECT_EQ(visitor.wished<BreedOn>(), nullptr);
    EXPECT_EQ(visitor.screen(), Screen::Ask);
    timings.can_breed_on = false;
    Visitor other(timings);
    other.grown().press(Choice::D);
    EXPECT_EQ(other.wished<BreedOn>(), nullptr);
}

TEST(Wall, IsNotPlayedOn) {
    Timings timings;
    timings.is_wall = true;
    Visitor visitor(timings);
    visitor.grown().press(Choice::A).press(Choice::D);
    EXPECT_EQ(visitor.screen(), Screen::Attract);
    EXPECT_NE(visitor.wished<Acknowledge>(), nullptr);
}

}  // namespace
}  // namespace quadrat::exhibit
