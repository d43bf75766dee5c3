// SPDX-License-Identifier: Apache-2.0
// What is asked about a landscape once it is bred.
#include <gtest/gtest.h>

#include "unit/exhibit/visit_fixture.hpp"

namespace quadrat::exhibit {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

Timings always(int words) {
    Timings timings;
    timings.rounds = 1;
    timings.describe_words = words;
    timings.describe_every = 1;
    return timings;
}

Visitor at_the_finale(const Timings& timings) {
    Visitor visitor(timings);
    visitor.arrive().press(Choice::A).press(Choice::A).press(Choice::A).grown();
    EXPECT_EQ(visitor.screen(), Screen::Finale);
    return visitor;
}

TEST(Describe, AsksOneWordAtATimeAndKeepsEachAnswer) {
    Visitor visitor = at_the_finale(always(2));
    visitor.wait(seconds(2)).press(Choice::A);
    ASSERT_EQ(visitor.screen(), Screen::Describe) << "the press left the finale and is no answer";
    EXPECT_EQ(visitor.wished<KeepWord>(), nullptr);
    visitor.press(Choice::D);
    EXPECT_EQ(*visitor.wished<KeepWord>(), (KeepWord{0, 3}));
    EXPECT_EQ(visitor.screen(), Screen::Describe);
    visitor.press(Choice::B);
    EXPECT_EQ(*visitor.wished<KeepWord>(), (KeepWord{1, 1}));
    EXPECT_EQ(*visitor.wished<EndVisit>(), (EndVisit{Ending::Finished, 1}));
    EXPECT_EQ(visitor.screen(), Screen::Attract);
    EXPECT_EQ(visitor.state().described, 0);
}

TEST(Describe, ComesAfterAFinaleThatNobodyInterruptedToo) {
    Visitor visitor = at_the_finale(always(1));
    visitor.wait(seconds(20));
    EXPECT_EQ(visitor.screen(), Screen::Describe);
}

TEST(Describe, IsSkippedByFifteenSecondsWithoutAPress) {
    Visitor visitor = at_the_finale(always(3));
    visitor.wait(seconds(20));
    visitor.wait(milliseconds(14'999));
    ASSERT_EQ(visitor.screen(), Screen::Describe);
    visitor.wait(milliseconds(1));
    EXPECT_EQ(visitor.screen(), Screen::Attract);
    EXPECT_EQ(visitor.wished<KeepWord>(), nullptr);
    EXPECT_EQ(*visitor.wished<EndVisit>(), (EndVisit{Ending::Finished, 1}));
}

TEST(Describe, WaitsAnewAfterEachAnswer) {
    Visitor visitor = at_the_finale(always(3));
    visitor.wait(seconds(20)).wait(seconds(14)).press(Choice::C).wait(seconds(14));
    EXPECT_EQ(visitor.screen(), Screen::Describe);
    visitor.wait(seconds(1));
    EXPECT_EQ(visitor.screen(), Screen::Attract);
}

TEST(Describe, IsLeftByBackWithoutAnAnswer) {
    Visitor visitor = at_the_finale(always(3));
    visitor.wait(seconds(20)).press(Choice::Back);
    EXPECT_EQ(visitor.wished<KeepWord>(), nullptr);
    EXPECT_EQ(visitor.screen(), Screen::Attract);
}

TEST(Describe, DoesNotCountAPressThatWasMeantForTheWordBefore) {
    Visitor visitor = at_the_finale(always(3));
    visitor.wait(seconds(20)).press(Choice::A).send(Pressed{Choice::B});
    EXPECT_EQ(visitor.state().described, 1);
    EXPECT_NE(visitor.wished<Acknowledge>(), nullptr) << "but it is acknowledged";
}

TEST(Describe, ComesNowAndThenOrNever) {
    for (const auto& [words, every, expected] :
         {std::tuple{1, 2, std::vector<Screen>{Screen::Attract, Screen::Describe, Screen::Attract, Screen::Describe}},
          std::tuple{0, 1, std::vector<Screen>{Screen::Attract, Screen::Attract}}}) {
        Timings timings = always(words);
        timings.describe_every = every;
        Visitor visitor(timings);
        visitor.grown();
        for (const Screen screen : expected) {
            visitor.press(Choice::A).press(Choice::A).press(Choice::A).press(Choice::A).grown();
            visitor.grown().wait(seconds(20));
            EXPECT_EQ(visitor.screen(), screen);
            if (screen == Screen::Describe) visitor.press(Choice::A);
        }
    }
}

}  // namespace
}  // namespace quadrat::exhibit
