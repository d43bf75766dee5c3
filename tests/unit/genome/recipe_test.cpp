// SPDX-License-Identifier: Apache-2.0
#include "genome/recipe.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "genome/json_text.hpp"
#include "genome/offer_json.hpp"
#include "support/effort.hpp"

namespace quadrat::genome {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string error_of(std::string_view json) {
    try {
        from_json(json, "scene.json");
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "no error";
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

Pick pick_of(std::optional<std::size_t> trees, std::optional<std::size_t> land, std::optional<std::size_t> sky) {
    Pick pick;
    pick.each = {trees, land, sky};
    return pick;
}

const std::string& good() {
    static const std::string json = to_json(random_recipe(base::Seed{7}));
    return json;
}

TEST(Recipe, ComesBackExactlyFromItsJson) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const Recipe recipe = random_recipe(base::Seed{i});
        ASSERT_EQ(from_json(to_json(recipe), "test"), recipe) << to_json(recipe);
    }
}

TEST(Recipe, OfARandomSeedIsInRangeWholeInItsChoicesAndDiffersFromTheNext) {
    for (std::uint64_t i = 0; i < 200; ++i) {
        const Recipe recipe = random_recipe(base::Seed{i});
        for (const Parameter& p : parameter_table()) {
            EXPECT_GE(recipe.values[p.id], p.min);
            EXPECT_LE(recipe.values[p.id], p.max);
            if (p.unit.empty() || p.unit == kChoice) {
                EXPECT_EQ(recipe.values[p.id], std::round(recipe.values[p.id])) << p.name;
            }
        }
        EXPECT_NE(recipe.values, random_recipe(base::Seed{i + 1}).values);
        EXPECT_EQ(recipe, random_recipe(base::Seed{i}));
    }
}

TEST(Recipe, OfACandidateHasItsValuesItsSeedsAndTheFlight) {
    Candidate candidate;
    candidate.values = random_recipe(base::Seed{3}).values;
    candidate.seeds[Aspect::Land] = base::Seed{42};
    const Recipe recipe = recipe_of(candidate, base::Seed{9});
    EXPECT_EQ(recipe.values, candidate.values);
    EXPECT_EQ(recipe.seeds, candidate.seeds);
    EXPECT_EQ(recipe.flight, base::Seed{9});
    EXPECT_EQ(candidate_of(recipe), candidate);
}

TEST(Recipe, TakesTheDefaultOfAParameterThatIsLeftOut) {
    const Recipe recipe = from_json(
        R"({"quadrat":"scene","version":1,"seeds":{"trees":"0000000000000001","land":"0000000000000002",
            "sky":"ffffffffffffffff"},"camera":"0000000000000004","parameters":{"tree.type":2}})",
        "test");
    ParameterValues expected;
    expected.set(*parameter_named("tree.type"), 2);
    EXPECT_EQ(recipe.values, expected);
    EXPECT_EQ(recipe.seeds[Aspect::Sky].value, ~std::uint64_t{0});
    EXPECT_EQ(recipe.flight.value, 4U);
}

TEST(Recipe, KeepsTheRangesEndsAsTheyStandInTheTable) {
    for (const bool is_greatest : {false, true}) {
        Recipe recipe;
        for (const Parameter& p : parameter_table()) recipe.values.set(p.id, is_greatest ? p.max : p.min);
        EXPECT_EQ(from_json(to_json(recipe), "test"), recipe);
    }
}

TEST(RecipeError, NamesTheLineOfMalformedJson) {
    EXPECT_THAT(error_of("{\n\"quadrat\":\"scene\",\n\"version\":,\n}"), HasSubstr("scene.json:3: not JSON"));
    EXPECT_THAT(error_of(""), HasSubstr("scene.json:1: not JSON"));
    EXPECT_THAT(error_of(good().substr(0, good().size() - 1)), HasSubstr("scene.json:1: not JSON"));
    EXPECT_THAT(error_of("\n\n\n\"\xff\xfe\""), AllOf(HasSubstr("scene.json:4: not JSON"), Not(HasSubstr("\xff"))));
}

TEST(RecipeError, NamesAnotherKindOrVersionOfFile) {
    EXPECT_THAT(error_of("[]"), HasSubstr("the file is a list; it should be an object"));
    EXPECT_THAT(error_of("{}"), HasSubstr("the key quadrat is missing"));
    EXPECT_THAT(error_of(replaced(good(), "\"scene\"", "\"sound\"")), HasSubstr("quadrat is \"sound\""));
    EXPECT_THAT(error_of(replaced(good(), "\"version\":1", "\"version\":2")),
                HasSubstr("version is 2; this program reads version 1"));
}

TEST(RecipeError, NamesTheUnknownParameterAndTheUnknownKey) {
    EXPECT_THAT(error_of(replaced(good(), "tree.type", "tree.tipe")), HasSubstr("unknown parameter \"tree.tipe\""));
    EXPECT_THAT(error_of(replaced(good(), "\"camera\"", "\"kamera\"")), HasSubstr("unknown key \"kamera\""));
    EXPECT_THAT(error_of(replaced(good(), "{\"quadrat\"", "{\"version\":1,\"quadrat\"")),
                HasSubstr("\"version\" stands twice"));
}

TEST(RecipeError, NamesTheValueOutsideItsRangeAndTheRange) {
    for (const Parameter& p : parameter_table()) {
        const auto with = [&](const std::string& value) {
            return error_of(R"({"quadrat":"scene","version":1,"parameters":{")" + std::string(p.name) + "\":" + value +
                            "}}");
        };
        const std::string right = "it should be a number from " + shortest(p.min) + " to " + shortest(p.max);
        for (const std::string& wrong : {shortest(p.max * 2 + 1000), shortest(p.min - 1), std::string("\"4\""),
                                         std::string("null"), std::string("[1]"), std::string("1e300")})
            EXPECT_THAT(with(wrong),
                        AllOf(HasSubstr("scene.json: parameters." + std::string(p.name)), HasSubstr(right)));
        EXPECT_THAT(with("1e999"), HasSubstr("scene.json"));
        EXPECT_THAT(with("NaN"), HasSubstr("not JSON"));
    }
}

TEST(RecipeError, NamesTheSeedThatIsNotSixteenHexadecimalDigits) {
    EXPECT_THAT(error_of(replaced(good(), "\"trees\":\"", "\"trees\":\"x")), HasSubstr("seeds.trees is \"x"));
    EXPECT_THAT(error_of(replaced(good(), "\"camera\":\"", "\"camera\":\"0")),
                HasSubstr("it should be 16 hexadecimal digits"));
    EXPECT_THAT(error_of(R"({"quadrat":"scene","version":1,"parameters":{},"camera":"0000000000000004","seeds":{}})"),
                HasSubstr("seeds.trees is missing"));
}

TEST(RecipeError, IsOneLineForInputNestedAThousandDeep) {
    EXPECT_THAT(error_of(std::string(100'000, '[')), HasSubstr("nested deeper than 16"));
    std::string objects;
    for (int i = 0; i < 1000; ++i) objects += "{\"a\":";
    EXPECT_THAT(error_of(objects), AllOf(HasSubstr("nested deeper"), Not(HasSubstr("\n"))));
}

TEST(Numbers, AreWrittenShortAndComeBackExactly) {
    EXPECT_EQ(shortest(41.2F), "41.2");
    EXPECT_EQ(shortest(4.0F), "4");
    EXPECT_EQ(shortest(0.5), "0.5");
    base::RandomStream chance(base::Seed{11});
    for (int i = 0; i < 200'000; ++i) {
        const float wanted = chance.between(-5000.0F, 5000.0F) * std::exp2(-static_cast<float>(chance.below(20)));
        const auto read = nlohmann::json::parse(shortest(wanted)).get<double>();
        ASSERT_EQ(static_cast<float>(read), wanted);
        const double precise = chance.unit();
        ASSERT_EQ(nlohmann::json::parse(shortest(precise)).get<double>(), precise);
    }
}

TEST(Offer, ComesBackExactlyFromItsJson) {
    for (std::uint64_t i = 0; i < 200; ++i) {
        Offer offer;
        offer.round = static_cast<int>(i) + 1;
        for (std::size_t c = 0; c < kCandidates; ++c) {
            const Recipe recipe = random_recipe(base::Seed{i}.child(c));
            offer.candidates[c] = {encode(recipe.values, Genome::Classic), recipe.values, recipe.seeds, {}};
        }
        ASSERT_EQ(offer_from_json(to_json(offer), "test"), offer);
    }
}

TEST(Offer, IsNotReadFromDamagedJson) {
    const std::string json = to_json(Offer{});
    EXPECT_EQ(offer_from_json(json, "test"), Offer{});
    for (std::size_t length = 0; length < json.size(); length += 17)
        EXPECT_THROW(offer_from_json(json.substr(0, length), "test"), base::InputError) << length;
    EXPECT_THROW(offer_from_json(replaced(json, "\"round\":1", "\"round\":0"), "test"), base::InputError);
    EXPECT_THROW(offer_from_json(replaced(json, "\"round\":1", "\"round\":99999999999"), "test"), base::InputError);
    EXPECT_THROW(offer_from_json(replaced(json, "\"trees\":\"\"", "\"trees\":\"2\""), "test"), base::InputError);
    EXPECT_THROW(offer_from_json(R"({"round":1,"candidates":[]})", "test"), base::InputError);
}

TEST(Pick, ComesBackFromItsJsonWithTheAspectsThatWereNotJudged) {
    for (const Pick& pick : {Pick{}, pick_of(2, {}, 0), pick_of(0, 1, 3), pick_of({}, {}, 3)})
        EXPECT_EQ(pick_from_json(to_json(pick), "test"), pick) << to_json(pick);
    EXPECT_EQ(to_json(pick_of(2, {}, 0)), R"({"trees":2,"sky":0})");
    EXPECT_THROW(pick_from_json(R"({"trees":4})", "test"), base::InputError);
    EXPECT_THROW(pick_from_json(R"({"trees":-1})", "test"), base::InputError);
    EXPECT_THROW(pick_from_json(R"({"trees":1.0})", "test"), base::InputError);
    EXPECT_THROW(pick_from_json(R"({"water":1})", "test"), base::InputError);
}

}  // namespace
}  // namespace quadrat::genome
