// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/own_word.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/seed.hpp"
#include "genome/words_json.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::WordId;
using nlohmann::json;
using testing::HasSubstr;

// Somebody who calls lands "Irish" that are wet, green and gently rolling, and says so to a tenth.
double irish(const genome::Description& words) {
    return 0.5 * words[WordId::wet] + 0.4 * words[WordId::green] - 0.4 * words[WordId::rugged] - 0.1;
}

json ten_scenes(std::uint64_t seed, bool by_parameters = false) {
    base::RandomStream chance{base::Seed{seed}};
    json scenes = json::array();
    for (int i = 0; i < 10; ++i) {
        genome::Description words;
        json said = json::object();
        for (const genome::Word& word : genome::vocabulary(Aspect::Land)) {
            words.set(word.id, chance.between(-0.8F, 0.8F));
            said[std::string(word.name)] = words[word.id];
        }
        const double value = std::clamp(irish(words) + 0.05 * static_cast<double>(chance.normal()), -1.0, 1.0);
        if (!by_parameters) {
            scenes.push_back({{"value", value}, {"words", said}});
            continue;
        }
        const genome::ParameterValues values = default_word_map()(words);
        json parameters = json::object();
        for (const auto id : parameters_of(Aspect::Land, genome::Genome::Full))
            parameters[std::string(parameter(id).name)] = values[id];
        scenes.push_back({{"value", value}, {"parameters", parameters}});
    }
    return scenes;
}

json file_of(const json& scenes) {
    return {{"quadrat", "own word"}, {"version", 1}, {"name", "Irish"}, {"aspect", "land"}, {"scenes", scenes}};
}

OwnWord learnt(const json& scenes) { return own_word_from(file_of(scenes).dump(), "irish.json", default_word_map()); }

// What its inventor says of the scenes that it asks for.
double mean_miss(bool by_parameters) {
    double missed = 0;
    int asked = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const OwnWord own = learnt(ten_scenes(seed, by_parameters));
        for (const double value : {-0.6, -0.2, 0.2, 0.6}) {
            missed += std::abs(irish(default_word_map().completed({}, std::vector{own.at(value)})) - value);
            ++asked;
        }
    }
    return missed / asked;
}

TEST(OwnWord, OfTenDescribedScenesIsUnderstood) { EXPECT_LT(mean_miss(false), 0.15); }

TEST(OwnWord, OfTenScenesWithoutWordsIsUnderstoodToo) { EXPECT_LT(mean_miss(true), 0.3); }

TEST(OwnWord, TellsItsScenesFromOneAnotherBetterThanByGuessing) {
    double share = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const OwnWord own = learnt(ten_scenes(seed));
        EXPECT_LT(own.leave_one_out, own.spread_of_said) << seed;
        share += own.leave_one_out / own.spread_of_said / 8;
    }
    EXPECT_LT(share, 0.6);
}

TEST(OwnWord, AsksForNoMoreThanThereIsAndKeepsWordsThatAreGiven) {
    const OwnWord own = learnt(ten_scenes(3));
    genome::PartialDescription given{};
    given[static_cast<std::size_t>(WordId::wet)] = -1.0F;
    const genome::Description words = default_word_map().completed(given, std::vector{own.at(1)});
    EXPECT_EQ(words[WordId::wet], -1);
    EXPECT_GT(words[WordId::green], 0.5F) << "the others make up for it";
    for (const genome::Word& word : genome::vocabulary()) EXPECT_LE(std::abs(words[word.id]), 1) << word.name;
}

TEST(OwnWord, RefusesWhatCannotBeOneInOneLine) {
    const auto message = [](const json& file) -> std::string {
        try {
            own_word_from(file.dump(), "mine.json", default_word_map());
        } catch (const base::InputError& error) {
            return error.what();
        }
        return "";
    };
    json scenes = ten_scenes(1);
    json few = scenes;
    few.erase(0);
    EXPECT_EQ(message(file_of(few)), "mine.json: scenes should be a list of at least 10; it has 9");
    json taken = file_of(scenes);
    taken["name"] = "wet";
    EXPECT_THAT(message(taken), HasSubstr("which is a word already"));
    json other = file_of(scenes);
    other["version"] = 2;
    EXPECT_THAT(message(other), HasSubstr("another kind or version"));
    const auto changed = [&](const auto& change) {
        json file = file_of(scenes);
        change(file["scenes"][4]);
        return message(file);
    };
    EXPECT_THAT(changed([](json& s) { s["value"] = 1.5; }), HasSubstr("scenes[4].value is 1.5"));
    EXPECT_THAT(changed([](json& s) { s["words"]["nice"] = 1; }), HasSubstr("scenes[4].words names the word \"nice\""));
    EXPECT_THAT(changed([](json& s) { s["words"]["misty"] = 1; }), HasSubstr("which is of the sky, not of the land"));
    EXPECT_THAT(changed([](json& s) { s["words"]["wet"] = -2; }), HasSubstr("a word is a number from -1 to 1"));
    EXPECT_THAT(changed([](json& s) { s.erase("words"); }), HasSubstr("either words or parameters"));
    for (json& scene : scenes) scene["value"] = 0.5;
    EXPECT_THAT(message(file_of(scenes)), HasSubstr("all scenes have about the same value"));
}

}  // namespace
}  // namespace quadrat::breeding
