// SPDX-License-Identifier: Apache-2.0
#include "genome/words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "base/error.hpp"
#include "genome/speech.hpp"

namespace quadrat::genome {
namespace {

TEST(Words, HoldThePapersSeven) {
    for (const char* name : {"wet", "sparse", "tropical", "cloudy", "light", "mountainous", "undulating"})
        EXPECT_TRUE(word_named(name)) << name;
    EXPECT_FALSE(word_named("nice"));
}

TEST(Words, AreSixToEightAnAspectWithDifferentNamesAndEnds) {
    std::set<std::string_view> names;
    for (const Aspect aspect : kAspects) {
        EXPECT_GE(vocabulary(aspect).size(), 6U);
        EXPECT_LE(vocabulary(aspect).size(), 8U);
    }
    for (const Word& word : vocabulary()) {
        EXPECT_TRUE(names.insert(word.name).second) << word.name;
        EXPECT_NE(word.low, word.high);
        EXPECT_EQ(word_named(word.name), word.id);
    }
}

TEST(Words, AreClampedToTheirEnds) {
    Description description;
    description.set(WordId::wet, 3);
    description.set(WordId::tall, -7);
    description.set(WordId::misty, std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(description[WordId::wet], 1);
    EXPECT_EQ(description[WordId::tall], -1);
    EXPECT_EQ(description[WordId::misty], 0);
}

Description evening() {
    Description description;
    description.set(WordId::tall, 0.9F);
    description.set(WordId::sparse, 0.5F);
    description.set(WordId::leafy, 0.3F);  // the third: not said
    description.set(WordId::wet, -0.4F);
    description.set(WordId::warm, 0.2F);  // too weak to say
    return description;
}

TEST(Speech, SaysTheTwoStrongestWordsOfEachAspect) {
    EXPECT_EQ(language("en").describe(evening()), "dry land; very tall and scattered trees; an everyday sky");
    EXPECT_EQ(language("de").describe(evening()),
              "trockenes Land; sehr hohe und vereinzelte Bäume; gewöhnlicher Himmel");
}

TEST(Speech, TellsApartByEarWhatItWouldDescribeAlike) {
    std::array<std::optional<Description>, 4> four;
    for (auto& one : four) {
        one.emplace();
        one->set(WordId::wet, 0.9F);
        one->set(WordId::narrow, -0.5F);
    }
    const Language& english = language("en");
    EXPECT_EQ(english.describe_among(four, 0, Aspect::Land), english.describe(*four[0], Aspect::Land))
        << "no difference";
    four[1].reset();
    four[2]->set(WordId::wet, -0.9F);
    four[0]->set(WordId::mountainous, 0.1F);
    four[3]->set(WordId::mountainous, -0.2F);
    four[3]->set(WordId::cold, 0.1F);
    const std::string alike = english.describe(*four[0], Aspect::Land);
    ASSERT_EQ(english.describe(*four[3], Aspect::Land), alike);
    EXPECT_EQ(english.describe_among(four, 0, Aspect::Land), alike + ", rather mountainous");
    EXPECT_EQ(english.describe_among(four, 3, Aspect::Land), alike + ", rather flat");
    EXPECT_EQ(english.describe_among(four, 2, Aspect::Land), english.describe(*four[2], Aspect::Land));
}

TEST(Speech, SaysWhatChanged) {
    Description later = evening();
    later.set(WordId::tall, -0.2F);
    later.set(WordId::gnarled, 0.6F);
    EXPECT_EQ(language("en").heredity(evening(), later, Aspect::Trees), "low, gnarled");
    EXPECT_EQ(language("en").heredity(evening(), later, Aspect::Sky), "");
}

ParameterShares only(ParameterId id, float share) {
    ParameterShares moved(parameter_table().size());
    moved[static_cast<std::size_t>(id)] = share;
    return moved;
}

TEST(Speech, SaysTheOneDetailThatMovedMost) {
    ParameterShares moved = only(*parameter_named("tree.crown_width"), 0.2F);
    moved[static_cast<std::size_t>(*parameter_named("flower.share"))] = -0.1F;
    EXPECT_EQ(language("en").detail(moved, Aspect::Trees), "wider crowns");
    EXPECT_EQ(language("de").detail(moved, Aspect::Trees), "breitere Kronen");
    EXPECT_EQ(language("en").detail(moved, Aspect::Land), "");
    EXPECT_EQ(language("en").detail(only(*parameter_named("flower.share"), -0.1F), Aspect::Trees), "fewer flowers");
    EXPECT_EQ(language("en").detail(only(*parameter_named("flower.share"), -0.02F), Aspect::Trees), "")
        << "nobody sees it";
    EXPECT_EQ(language("en").detail(only(*parameter_named("tree.fruit_m"), 0.9F), Aspect::Trees), "")
        << "nobody names it";
}

TEST(Speech, KnowsEveryDetailInEveryLanguageInItsOwnWords) {
    const auto& english = language("en");
    for (const std::string_view code : language_codes()) {
        std::set<std::string_view> said;
        for (const Parameter& p : parameter_table())
            for (const bool is_more : {false, true}) {
                const std::string_view text = language(code).detail(p.id, is_more);
                if (english.detail(p.id, is_more).empty()) {
                    EXPECT_TRUE(text.empty()) << code << " " << p.name;
                    continue;
                }
                EXPECT_TRUE(said.insert(text).second) << code << " " << text;
                if (code != "en") {
                    EXPECT_NE(text, english.detail(p.id, is_more)) << code;
                }
            }
        EXPECT_GE(said.size(), 40U);
    }
}

TEST(Speech, FallsBackToEnglish) {
    EXPECT_EQ(language("tlh").name(), "English");
    EXPECT_EQ(language("").name(), "English");
    EXPECT_EQ(language("de_AT.UTF-8").name(), "Deutsch");
    EXPECT_EQ(language("fr-CA").name(), "Français");
}

TEST(Speech, KnowsEveryWordInEveryLanguageAndNoTwoEndsOfAnAspectAlike) {
    EXPECT_THAT(language_codes(), testing::IsSupersetOf({"ar", "de", "el", "en", "es", "fr", "he", "hi", "it", "ja",
                                                         "nl", "pl", "pt", "tr", "uk", "xh", "zh"}));
    for (const std::string_view code : language_codes())
        for (const Aspect aspect : kAspects) {
            std::set<std::string_view> ends;
            for (const Word& word : vocabulary(aspect))
                for (const bool is_high : {false, true}) {
                    EXPECT_FALSE(language(code).end(word.id, is_high).empty());
                    EXPECT_TRUE(ends.insert(language(code).end(word.id, is_high)).second)
                        << code << " " << language(code).end(word.id, is_high);
                }
        }
}

TEST(Speech, AsksInEveryLanguageAndFallsBackToEnglishWhereOneDoesNot) {
    for (const std::string_view code : language_codes()) {
        std::set<std::string_view> prompts;
        for (const std::string_view key : kPrompts) {
            EXPECT_FALSE(language(code).prompt(key).empty()) << code << " " << key;
            EXPECT_TRUE(prompts.insert(prompt(code, key)).second) << code << " " << prompt(code, key);
            EXPECT_EQ(code != "en" && prompt(code, key) == prompt("en", key), false) << code << " " << key;
        }
    }
    EXPECT_EQ(prompt("tlh", "describe.sky"), "Which words suit this sky?");
    EXPECT_EQ(prompt("de", "describe.sky"), "Welche Worte passen zu diesem Himmel?");
}

TEST(Speech, AnswersInFourStepsFromOneEndToTheOther) {
    EXPECT_THAT(language("en").answers(WordId::wet),
                testing::ElementsAre("dry land", "rather dry land", "rather wet land", "wet land"));
    EXPECT_THAT(
        language("fr").answers(WordId::cloudy),
        testing::ElementsAre("un ciel dégagé", "un ciel plutôt dégagé", "un ciel plutôt nuageux", "un ciel nuageux"));
    for (const std::string_view code : language_codes())
        for (const Word& word : vocabulary()) {
            const auto answers = language(code).answers(word.id);
            EXPECT_EQ(std::set<std::string>(answers.begin(), answers.end()).size(), 4U) << code << " " << word.name;
        }
}

TEST(Speech, RefusesABrokenLanguageByKey) {
    const auto message = [](std::string_view text) -> std::string {
        try {
            Language::from_json(text, "xx.json");
        } catch (const base::InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(message(R"({"language":"X","sentence":"{trees}"})"),
                testing::HasSubstr("sentence has no place for {land}"));
    EXPECT_THAT(message(R"({"lang":"X"})"), testing::HasSubstr("xx.json"));
    EXPECT_THAT(message(R"({"language":"X","sentence":"{trees}{land}{sky}","and":"{}","very":"{}","rather":"{}",
        "trees":{"with":"{}","plain":""},"land":{"with":"{}","plain":""},"sky":{"with":"{}","plain":""},
        "words":{"nice":["a","b"]}})"),
                testing::HasSubstr("there is no word \"nice\""));
    EXPECT_THAT(message(R"({"language":"X","sentence":"{trees}{land}{sky}","and":"{}","very":"{}","rather":"{}",
        "trees":{"with":"{}","plain":""},"land":{"with":"{}","plain":""},"sky":{"with":"{}","plain":""},
        "words":{},"prompts":{"ask.sea":"?"}})"),
                testing::HasSubstr("there is no prompt \"ask.sea\""));
}

}  // namespace
}  // namespace quadrat::genome
