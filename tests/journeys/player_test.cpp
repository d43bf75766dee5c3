// SPDX-License-Identifier: Apache-2.0
// Another program plays quadrat breed --stdio: it reads each offer before it answers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "journeys/quadrat_program.hpp"
#include "support/conversation.hpp"

namespace {

using namespace quadrat::tests;
using nlohmann::json;

const std::map<std::string, std::vector<std::string>> kAspects{
    {"trees", {"tropical", "sparse", "tall", "leafy", "colourful", "slender", "gnarled"}},
    {"land", {"wet", "mountainous", "undulating", "rugged", "green", "cold", "narrow", "settled"}},
    {"sky", {"cloudy", "light", "warm", "misty", "stormy", "vivid"}}};

const json kWish{{"tropical", -0.6}, {"sparse", 0.2},   {"tall", 0.8},  {"leafy", 0.5},       {"colourful", -0.4},
                 {"slender", 0.6},   {"gnarled", -0.5}, {"wet", 0.4},   {"mountainous", 0.7}, {"undulating", 0.1},
                 {"rugged", 0.5},    {"green", 0.3},    {"cold", 0.5},  {"narrow", 0.4},      {"settled", -0.3},
                 {"cloudy", 0.3},    {"light", 0.5},    {"warm", -0.3}, {"misty", 0.4},       {"stormy", -0.3},
                 {"vivid", 0.2}};

double distance(const json& words, const std::string& aspect) {
    double squares = 0;
    for (const std::string& word : kAspects.at(aspect))
        squares += std::pow(words[word].get<double>() - kWish[word].get<double>(), 2);
    return std::sqrt(squares);
}

double distance(const json& words) {
    double squares = 0;
    for (const auto& [aspect, names] : kAspects) squares += std::pow(distance(words, aspect), 2);
    return std::sqrt(squares);
}

json best_of(const json& offer) {
    json pick = json::object();
    for (const auto& [aspect, names] : kAspects) {
        int best = 0;
        for (int c = 1; c < 4; ++c)
            if (distance(offer["candidates"][c]["words"], aspect) <
                distance(offer["candidates"][best]["words"], aspect))
                best = c;
        pick[aspect] = best;
    }
    return pick;
}

json means_of(const json& state) {
    json means = json::object();
    for (const auto& [aspect, names] : kAspects)
        for (const std::string& word : names) means[word] = state[aspect][word]["mean"];
    return means;
}

double deviation_of(const json& state) {
    double sum = 0;
    for (const auto& [aspect, names] : kAspects)
        for (const std::string& word : names) sum += state[aspect][word]["deviation"].get<double>();
    return sum;
}

TEST(Player, ComesNearerToItsWishAndTheBeliefKnowsIt) {
    Conversation quadrat(program({"breed", "--stdio", "--seed", "5"}));
    EXPECT_EQ(json::parse(quadrat.listen())["breeder"], "belief");
    json offer = json::parse(quadrat.listen());
    const json first = offer["state"];
    for (int round = 1; round <= 6; ++round) {
        EXPECT_EQ(offer["round"], round);
        offer = json::parse(quadrat.say(json{{"pick", best_of(offer)}}.dump()));
    }
    const json last = json::parse(quadrat.say("{\"state\":true}"))["state"];
    EXPECT_EQ(last, offer["state"]);
    EXPECT_LT(distance(means_of(last)), 0.7 * distance(means_of(first)));
    EXPECT_LT(deviation_of(last), 0.9 * deviation_of(first));
    const json scene = json::parse(quadrat.say(json{{"describe", means_of(last)}}.dump()));
    EXPECT_EQ(scene["type"], "scene");
    EXPECT_THAT(scene["sentence"].get<std::string>(), testing::HasSubstr(";"));
    EXPECT_EQ(quadrat.say("{\"quit\":true}"), "");
    EXPECT_EQ(quadrat.end(), 0);
}

TEST(Player, KeepsALockedAspectAndACuratorsRange) {
    Conversation quadrat(program({"breed", "--stdio", "--seed", "6", "--lock", "land"}));
    quadrat.listen();
    json offer = json::parse(quadrat.listen());
    const json before = offer["state"];
    quadrat.say(R"({"range":{"light":[0.4,0.4],"misty":[-1,-0.2]}})");
    quadrat.say(R"({"lock":"trees"})");
    for (int round = 0; round < 3; ++round) offer = json::parse(quadrat.say(json{{"pick", best_of(offer)}}.dump()));
    EXPECT_EQ(offer["state"]["land"], before["land"]);
    EXPECT_EQ(offer["state"]["trees"], before["trees"]);
    EXPECT_NE(offer["state"]["sky"], before["sky"]);
    for (const json& candidate : offer["candidates"]) {
        EXPECT_NEAR(candidate["words"]["light"].get<double>(), 0.4, 1e-6);
        EXPECT_LE(candidate["words"]["misty"].get<double>(), -0.2 + 1e-6);
    }
    const json unlocked = json::parse(quadrat.say(R"({"unlock":"trees"})"));
    offer = json::parse(quadrat.say(json{{"pick", best_of(unlocked)}}.dump()));
    EXPECT_NE(offer["state"]["trees"], before["trees"]);
    EXPECT_EQ(quadrat.end(), 0) << "the end of its input ends it";
}

TEST(Player, TurnsSlidersToItsWishOneByOne) {
    Conversation quadrat(program({"breed", "--stdio", "--seed", "5", "--breeder", "sliders"}));
    EXPECT_EQ(json::parse(quadrat.listen())["breeder"], "sliders");
    quadrat.listen();
    json offer;
    for (const auto& [aspect, names] : kAspects)
        for (const std::string& word : names)
            offer = json::parse(quadrat.say(json{{"turn", {{word, kWish[word]}}}}.dump()));
    for (const auto& [aspect, names] : kAspects)
        for (const std::string& word : names)
            EXPECT_NEAR(offer["state"][aspect][word].get<double>(), kWish[word].get<double>(), 1e-9) << word;
    offer = json::parse(quadrat.say(R"({"choose":"misty"})"));
    offer = json::parse(quadrat.say(R"({"pick":{"sky":2}})"));
    EXPECT_NEAR(offer["state"]["sky"]["misty"].get<double>(), 1.0 / 3, 1e-6);
    EXPECT_EQ(json::parse(quadrat.say(R"({"turn":{"nonsense":1}})"))["type"], "error");
    EXPECT_EQ(quadrat.end(), 0);
}

}  // namespace
