// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/word_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "base/seed.hpp"
#include "breeding/words/comes_back.hpp"
#include "genome/parameter_rules.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::WordId;

double error_in_ranges(const genome::ParameterValues& a, const genome::ParameterValues& b, Aspect aspect) {
    double sum = 0;
    const auto ids = parameters_of(aspect, genome::Genome::Full);
    for (const auto id : ids) sum += std::abs(a[id] - b[id]) / (parameter(id).max - parameter(id).min);
    return sum / static_cast<double>(ids.size());
}

// Of words' distance at which people could not be expected to have meant another scene.
constexpr float kAlike = 0.12F;

bool are_alike(const DescribedScene& a, const DescribedScene& b) {
    for (std::size_t w = 0; w < a.words.size(); ++w)
        if (std::abs(a.words[w].value_or(0) - b.words[w].value_or(0)) > kAlike) return false;
    return a.aspect == b.aspect;
}

TEST(WordMap, AScenesOwnWordsGiveItBackWithinTwoHundredthsOfEachRange) {
    const WordMap& map = default_word_map();
    const auto all = how_scenes_come_back(map);
    int contradicted = 0;
    for (std::size_t i = 0; i < map.scenes().size(); ++i) {
        const DescribedScene& scene = map.scenes()[i];
        const bool is_contradicted = std::ranges::any_of(
            map.scenes(), [&](const DescribedScene& other) { return &other != &scene && are_alike(scene, other); });
        contradicted += is_contradicted ? 1 : 0;
        if (is_contradicted) continue;
        const ComesBack& back = all[i];
        EXPECT_LE(back.worst_error, 0.02) << scene.name << ", " << parameter(back.worst).name;
        EXPECT_LE(back.error, 0.02) << scene.name;
    }
    EXPECT_LE(contradicted, 4) << "archetypes are told apart by their words";
}

TEST(WordMap, HearsScenesLessFarWhereTheyStandDense) {
    std::vector<DescribedScene> scenes;
    base::RandomStream chance{base::Seed{2}};
    for (int i = 0; i < 30; ++i) {
        DescribedScene scene;
        scene.aspect = Aspect::Land;
        const float wide = i < 20 ? 0.15F : 1.0F;  // the first twenty stand together
        for (const genome::Word& word : genome::vocabulary(Aspect::Land))
            scene.words[static_cast<std::size_t>(word.id)] = wide * chance.between(-1, 1);
        scenes.push_back(scene);
    }
    const auto all = how_scenes_come_back(WordMap(scenes));
    double dense = 0;
    double thin = 0;
    for (std::size_t i = 0; i < scenes.size(); ++i) (i < 20 ? dense : thin) += all[i].radius / (i < 20 ? 20 : 10);
    EXPECT_LT(dense, 0.5 * thin);
}

TEST(WordMap, TellsAnAspectsParametersFromOtherScenesToAQuarterOfTheirRange) {
    for (const Aspect aspect : genome::kAspects) EXPECT_LT(default_word_map().leave_one_out(aspect), 0.25);
}

TEST(WordMap, EveryEndOfAWordMovesManyParameters) {
    for (const genome::Word& word : genome::vocabulary()) {
        genome::Description low;
        genome::Description high;
        low.set(word.id, -1);
        high.set(word.id, 1);
        const auto a = default_word_map()(low);
        const auto b = default_word_map()(high);
        EXPECT_GT(error_in_ranges(a, b, word.aspect), 0.01) << word.name;
    }
}

TEST(WordMap, ChangesGentlyAndKeepsRangesAndRules) {
    base::RandomStream chance{base::Seed{4}};
    for (int i = 0; i < 200; ++i) {
        genome::Description words;
        for (const genome::Word& word : genome::vocabulary()) words.set(word.id, chance.between(-1, 1));
        const genome::ParameterValues values = default_word_map()(words);
        for (const genome::Parameter& p : genome::parameter_table()) {
            EXPECT_GE(values[p.id], p.min) << p.name;
            EXPECT_LE(values[p.id], p.max) << p.name;
        }
        for (const genome::ParameterRule& rule : genome::parameter_rules()) {
            const float bound = rule.factor * values[rule.other] + rule.offset;
            const genome::Parameter& p = parameter(rule.id);
            if (rule.bound == genome::ParameterRule::Bound::AtLeast)
                EXPECT_GE(values[rule.id], std::min(bound, p.max) - 1e-3F) << rule.reason;
            else
                EXPECT_LE(values[rule.id], std::max(bound, p.min) + 1e-3F) << rule.reason;
        }
    }
}

TEST(WordMap, FillsInWordsThatWereLeftOut) {
    genome::PartialDescription asked{};
    asked[static_cast<std::size_t>(WordId::wet)] = 0.5F;
    const genome::Description description = default_word_map().completed(asked);
    EXPECT_EQ(description[WordId::wet], 0.5F);
    const genome::Description nothing = default_word_map().completed({});
    for (const genome::Word& word : genome::vocabulary()) EXPECT_LT(std::abs(nothing[word.id]), 0.6F) << word.name;
}

std::vector<DescribedScene> two_that_go_together() {
    std::vector<DescribedScene> scenes;
    base::RandomStream chance{base::Seed{1}};
    for (int i = 0; i < 60; ++i) {
        DescribedScene scene;
        scene.aspect = Aspect::Land;
        for (const genome::Word& word : genome::vocabulary(Aspect::Land))
            scene.words[static_cast<std::size_t>(word.id)] = chance.between(-1, 1);
        scene.words[static_cast<std::size_t>(WordId::green)] = scene.words[static_cast<std::size_t>(WordId::wet)];
        scenes.push_back(scene);
    }
    return scenes;
}

TEST(WordMap, KnowsWhichWordsGoTogether) {
    const WordMap map(two_that_go_together());
    genome::PartialDescription asked{};
    asked[static_cast<std::size_t>(WordId::wet)] = 0.8F;
    EXPECT_GT(map.completed(asked)[WordId::green], 0.4F);
    EXPECT_LT(std::abs(map.completed(asked)[WordId::cold]), 0.3F);
}

TEST(WordMap, WithFewerScenesThanWordsOrContradictionsOrNoneIsStillAMap) {
    const genome::ParameterValues defaults;
    EXPECT_EQ(WordMap({})(genome::Description{}), defaults);
    DescribedScene one = archetypes(Aspect::Land).front();
    DescribedScene other = archetypes(Aspect::Land).back();
    other.words = one.words;  // said alike, and not alike
    const WordMap map({one, other});
    const auto values = map(map.completed(one.words));
    for (const auto id : parameters_of(Aspect::Land, genome::Genome::Full)) {
        const float low = std::min(one.values[id], other.values[id]);
        const float high = std::max(one.values[id], other.values[id]);
        const float slack = 0.02F * (parameter(id).max - parameter(id).min);
        EXPECT_GE(values[id], low - slack) << parameter(id).name;
        EXPECT_LE(values[id], high + slack) << parameter(id).name;
    }
}

TEST(WordMap, TrainedTwiceIsTheSameMap) {
    const WordMap a(default_scenes());
    const WordMap b(default_scenes());
    genome::Description words;
    words.set(WordId::tall, 0.3F);
    words.set(WordId::stormy, -0.7F);
    EXPECT_EQ(a(words), b(words));
}

TEST(Archetypes, AreAtLeastTwelveAnAspectWithNamesAndWordsOfTheirOwn) {
    for (const Aspect aspect : genome::kAspects) {
        EXPECT_GE(archetypes(aspect).size(), 12U) << name_of(aspect);
        std::set<std::string> names;
        for (const DescribedScene& scene : archetypes(aspect)) {
            EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
            float strongest = 0;
            for (const auto& word : scene.words) strongest = std::max(strongest, std::abs(word.value_or(0)));
            EXPECT_GE(strongest, 0.25F) << scene.name << " embodies no word that anybody would use";
        }
    }
}

DescribedScene scene_of(float wet, float value, double weight = 1) {
    DescribedScene scene;
    scene.aspect = Aspect::Land;
    for (const genome::Word& word : genome::vocabulary(Aspect::Land))
        scene.words[static_cast<std::size_t>(word.id)] = word.id == WordId::wet ? wet : 0.0F;
    scene.values.set(*genome::parameter_named("land.sea_level"), value);
    scene.weight = weight;
    return scene;
}

float sea_level(const WordMap& map, float wet) {
    genome::Description words;
    words.set(WordId::wet, wet);
    return map(words)[*genome::parameter_named("land.sea_level")];
}

TEST(WordMap, BelievesThoseMoreWhoAreTrustedMore) {
    std::vector<DescribedScene> scenes;
    for (const float wet : {-0.8F, -0.4F, 0.0F, 0.4F, 0.8F}) {
        scenes.push_back(scene_of(wet, 0.1F, 1));
        scenes.push_back(scene_of(wet, 0.5F, 9));
    }
    EXPECT_NEAR(sea_level(WordMap(scenes), 0.2F), 0.46F, 0.02F) << "nine to one";
}

TEST(WordMap, GoesOnGentlyBeyondItsScenesInsteadOfFallingToZero) {
    std::vector<DescribedScene> scenes;
    for (int i = 0; i <= 8; ++i) {
        const float wet = -0.8F + 0.1F * static_cast<float>(i);
        scenes.push_back(scene_of(wet, 0.3F + 0.2F * wet));
    }
    const WordMap map(scenes);  // they end at the middle
    float before = sea_level(map, 0);
    for (const float wet : {0.25F, 0.5F, 0.75F, 1.0F}) {
        const float now = sea_level(map, wet);
        EXPECT_GE(now, before - 0.01F) << wet;
        // The scenes rise by 0.2 a word; shrunk as every weight is, the map goes on in their direction.
        EXPECT_GT(now, 0.3F + 0.1F * wet) << wet;
        EXPECT_LT(now, 0.3F + 0.3F * wet) << wet;
        before = now;
    }
}

TEST(DescribedScenes, ComeBackFromTheirText) {
    for (const Aspect aspect : genome::kAspects) {
        std::vector<DescribedScene> scenes = archetypes(aspect);
        scenes[0].weight = 0.25;
        EXPECT_EQ(described_scenes_from(to_json(scenes, aspect), "again"), scenes);
    }
}

class BadScenes : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(BadScenes, AreRefusedByPlace) {
    try {
        described_scenes_from(GetParam().first, "mine.json");
        FAIL() << GetParam().first;
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("mine.json"));
        EXPECT_THAT(error.what(), testing::HasSubstr(GetParam().second));
    }
}

std::string file_with(const std::string& scene) {
    return R"({"quadrat":"described","version":1,"aspect":"land","scenes":[)" + scene + "]}";
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadScenes,
    testing::Values(std::pair{std::string("nonsense"), std::string("mine.json:1")},
                    std::pair{std::string(R"({"quadrat":"described","version":2,"aspect":"land","scenes":[]})"),
                              std::string("another kind or version")},
                    std::pair{std::string(R"({"quadrat":"described","version":1,"aspect":"sea","scenes":[]})"),
                              std::string("an aspect is trees, land or sky")},
                    std::pair{file_with(R"({"words":{"nice":1},"parameters":{}})"),
                              std::string("\"nice\"; words for the land are wet")},
                    std::pair{file_with(R"({"words":{"tall":1},"parameters":{}})"), std::string("scenes[0].words")},
                    std::pair{file_with(R"({"words":{"wet":1.5},"parameters":{}})"),
                              std::string("a word is a number from -1 to 1")},
                    std::pair{file_with(R"({"words":{},"parameters":{"land.gain":9}})"), std::string("land.gain")},
                    std::pair{file_with(R"({"words":{},"parameters":{"sky.depth":0.5}})"),
                              std::string("which is of the sky")},
                    std::pair{file_with(R"({"words":{},"parameters":{},"weight":0})"), std::string("more than 0")}));

}  // namespace
}  // namespace quadrat::breeding
