// SPDX-License-Identifier: Apache-2.0
// Which language? is asked before the first question where a site offers several.
#include <gtest/gtest.h>

#include <optional>
#include <set>

#include "unit/exhibit/visit_fixture.hpp"

namespace quadrat::exhibit {
namespace {

using std::chrono::seconds;

Timings speaking(int languages) {
    Timings timings;
    timings.languages = languages;
    return timings;
}

TEST(Language, IsNotAskedWhereThereIsOnlyOne) {
    for (const int languages : {0, 1}) {
        Visitor visitor(speaking(languages));
        visitor.arrive();
        EXPECT_EQ(visitor.screen(), Screen::Ask);
        EXPECT_EQ(visitor.wished<SpeakLanguage>(), nullptr);
    }
}

TEST(Language, IsChosenByAButtonAndTheVisitBegins) {
    Visitor visitor(speaking(3));
    visitor.arrive();
    ASSERT_EQ(visitor.screen(), Screen::Language);
    EXPECT_EQ(prompt_of(visitor.state()), Prompt::WhichLanguage);
    EXPECT_EQ(visitor.wished<BeginVisit>(), nullptr) << "nobody has chosen yet";
    visitor.press(Choice::D);
    EXPECT_EQ(visitor.screen(), Screen::Language) << "there is no fourth";
    visitor.press(Choice::C);
    EXPECT_EQ(*visitor.wished<SpeakLanguage>(), (SpeakLanguage{2}));
    EXPECT_NE(visitor.wished<BeginVisit>(), nullptr);
    EXPECT_EQ(visitor.screen(), Screen::Ask);
}

TEST(Language, IsLeftByBackAndBySilenceWithoutAVisit) {
    Visitor visitor(speaking(2));
    visitor.arrive().press(Choice::Back);
    EXPECT_EQ(visitor.screen(), Screen::Attract);
    visitor.press(Choice::A);
    ASSERT_EQ(visitor.screen(), Screen::Language);
    EXPECT_FALSE(countdown_s(visitor.state(), visitor.now(), visitor.timings()));
    visitor.wait(speaking(2).patience - std::chrono::seconds{4});
    EXPECT_EQ(countdown_s(visitor.state(), visitor.now(), visitor.timings()), 4) << "it warns";
    visitor.wait(std::chrono::seconds{4});
    EXPECT_EQ(visitor.screen(), Screen::Attract);
    EXPECT_EQ(visitor.wished<EndVisit>(), nullptr);
    EXPECT_EQ(visitor.wished<BeginVisit>(), nullptr);
}

TEST(Language, WaitsForTheFirstFourLikeAnyVisit) {
    Visitor visitor(speaking(2));
    visitor.press(Choice::A).press(Choice::B);
    EXPECT_EQ(visitor.screen(), Screen::Breed);
    visitor.grown();
    EXPECT_EQ(visitor.screen(), Screen::Ask);
}

// By the buttons A to C each of them is reached, whatever their number; the page after the last one is the first.
TEST(Language, TurnsPagesWhereThereAreMoreThanFour) {
    for (int languages = 1; languages <= 40; ++languages) {
        std::set<int> reached;
        int first = 0, pages = 0;
        do {
            for (const Choice button : {Choice::A, Choice::B, Choice::C, Choice::D}) {
                const auto choice = language_on(button, first, languages);
                if (choice && !choice->turns_page) {
                    EXPECT_TRUE(reached.insert(choice->which).second) << languages;
                }
            }
            const auto turned = language_on(Choice::D, first, languages);
            ASSERT_EQ(turned && turned->turns_page, languages > 4);
            if (languages > 4) first = turned->which;
            ASSERT_LT(++pages, 20);
        } while (first != 0);
        EXPECT_EQ(reached.size(), static_cast<std::size_t>(languages));
        EXPECT_EQ(*reached.rbegin(), languages - 1);
    }
    EXPECT_EQ(language_on(Choice::Back, 0, 9), std::nullopt);
    Visitor visitor(speaking(6));
    visitor.arrive().press(Choice::D);
    ASSERT_EQ(visitor.screen(), Screen::Language);
    EXPECT_EQ(visitor.state().first_language, 3);
    visitor.press(Choice::B);
    EXPECT_EQ(*visitor.wished<SpeakLanguage>(), (SpeakLanguage{4}));
    EXPECT_EQ(visitor.state().first_language, 0);
}

}  // namespace
}  // namespace quadrat::exhibit
