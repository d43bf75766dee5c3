// SPDX-License-Identifier: Apache-2.0
#include "stage/spoken.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace quadrat::stage {
namespace {

using exhibit::Screen;
using std::chrono::seconds;

site::Configuration offering(std::vector<std::string> languages) {
    site::Configuration configuration;
    configuration.visit.language = "en";
    configuration.visit.languages = std::move(languages);
    return configuration;
}

TEST(Spoken, IsTheSitesUntilAVisitorChoosesAndAgainWhenTheyHaveGone) {
    Spoken spoken(offering({"en", "de", "he"}));
    EXPECT_EQ(spoken.shown(Screen::Ask, seconds(5)), "en");
    spoken.choose(1);
    EXPECT_EQ(spoken.shown(Screen::Ask, seconds(5)), "de");
    EXPECT_EQ(spoken.language().name(), "Deutsch");
    spoken.end_visit();
    EXPECT_EQ(spoken.shown(Screen::Finale, seconds(5)), "en");
}

TEST(Spoken, InvitesInOneLanguageAfterTheOther) {
    const Spoken spoken(offering({"en", "de", "he"}));
    EXPECT_EQ(spoken.shown(Screen::Attract, seconds(1)), "en");
    EXPECT_EQ(spoken.shown(Screen::Attract, seconds(5)), "de");
    EXPECT_EQ(spoken.shown(Screen::Language, seconds(9)), "he");
    EXPECT_EQ(spoken.shown(Screen::Attract, seconds(13)), "en");
    EXPECT_EQ(Spoken(offering({})).shown(Screen::Attract, seconds(5)), "en");
}

TEST(Spoken, GoesOnInAVisitorsLanguageAfterAPowerCutIfItIsOfferedStill) {
    Spoken spoken(offering({"en", "de"}));
    spoken.resume("de");
    EXPECT_EQ(spoken.code(), "de");
    spoken.resume("fr");
    spoken.resume("");
    EXPECT_EQ(spoken.code(), "de") << "not offered";
}

TEST(Spoken, FollowsTheSettingsAndLeavesAVisitorTheirs) {
    Spoken spoken(offering({"en", "de"}));
    spoken.choose(1);
    spoken.follow(offering({"de", "fr"}));
    EXPECT_EQ(spoken.code(), "de");
    spoken.follow(offering({"fr", "it"}));
    EXPECT_EQ(spoken.code(), "en") << "German is not offered any more";
    site::Configuration spanish = offering({"fr", "it"});
    spanish.visit.language = "es";
    spoken.follow(spanish);
    EXPECT_EQ(spoken.code(), "es");
}

TEST(Spoken, NamesEachLanguageInItself) {
    const Spoken few(offering({"en", "zh"}));
    EXPECT_THAT(few.labels(0), testing::ElementsAre("English", "中文", "", ""));
    const Spoken many(offering({"en", "zh", "fr", "de", "he"}));
    EXPECT_THAT(many.labels(0), testing::ElementsAre("English", "中文", "Français", "…"));
    EXPECT_THAT(many.labels(3), testing::ElementsAre("Deutsch", "עברית", "", "…"));
}

}  // namespace
}  // namespace quadrat::stage
