// SPDX-License-Identifier: Apache-2.0
#include "breeding/stdio_protocol.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::kAspects;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

StdioProtocol protocol_of(const PbilOptions& pbil, base::Seed seed = base::Seed{7}) {
    BreederOptions options;
    options.pbil = pbil;
    return StdioProtocol(Session(Breeder(options), seed));
}

// Every line but quit has an answer.
std::string answer_of(StdioProtocol& protocol, std::string_view line) {
    const auto answer = protocol.answer(line);
    return answer ? *answer : "no answer";
}

StdioProtocol protocol() { return protocol_of({}); }

std::string random_pick(base::RandomStream& chance) {
    json pick = json::object();
    for (const Aspect aspect : kAspects)
        if (chance.below(3) != 0) pick[std::string(name_of(aspect))] = chance.below(4);
    return json{{"pick", pick}}.dump();
}

TEST(StdioProtocol, SaysHelloWithTheClassicParametersInTheOrderOfTheTable) {
    const std::string hello = protocol().hello();
    EXPECT_THAT(hello, StartsWith(R"({"type":"hello","genome":"classic","breeder":"pbil","seed":7,)"
                                  R"("aspects":["trees","land","sky"],"parameters":[{"name":"tree.type",)"
                                  R"("aspect":"trees","unit":"choice","min":0,"max":7,"bits":3},)"
                                  R"({"name":"tree.branch_angle_deg","aspect":"trees","unit":"deg",)"
                                  R"("min":15,"max":60,"bits":3},)"));
    EXPECT_EQ(json::parse(hello)["parameters"].size(), 21U);
}

TEST(StdioProtocol, OffersFourCandidatesWithBitsParametersAndState) {
    const std::string line = protocol().offer();
    EXPECT_THAT(line, StartsWith(R"({"type":"offer","round":1,"candidates":[{"bits":{"trees":")"));
    EXPECT_THAT(line, HasSubstr(R"("words":{})"));
    EXPECT_THAT(line, HasSubstr(R"("state":{"trees":[0.5,0.5)"));
    const json offer = json::parse(line);
    ASSERT_EQ(offer["candidates"].size(), 4U);
    for (const json& candidate : offer["candidates"]) {
        EXPECT_EQ(candidate["parameters"].size(), 21U);
        for (const Aspect aspect : kAspects)
            EXPECT_EQ(candidate["bits"][std::string(name_of(aspect))].get<std::string>().size(),
                      bit_count(aspect, genome::Genome::Classic));
    }
}

// The formula of section 2.1.5 of the 2003 paper, from nothing but what the protocol printed.
std::vector<double> expected_state(const json& before, const std::string& aspect, const json& pick, bool is_locked,
                                   const PbilOptions& options, base::Seed mutation) {
    auto state = before["state"][aspect].get<std::vector<double>>();
    if (!pick.contains(aspect) || is_locked) return state;
    const auto bits = before["candidates"][pick[aspect].get<std::size_t>()]["bits"][aspect].get<std::string>();
    for (std::size_t i = 0; i < state.size(); ++i) {
        const double bit = bits[i] - '0';
        const double learnt = state[i] * (1.0 - options.learning_rate) + options.learning_rate * bit;
        const double m = options.mutation;
        const double u = base::RandomStream(mutation.child(aspect).child(i)).unit();
        state[i] = options.mutation_form == MutationForm::TowardHalf ? learnt + m * (0.5 - learnt)
                                                                     : learnt * (1.0 - m) + m * u;
    }
    return state;
}

class StdioState : public testing::TestWithParam<PbilOptions> {};
INSTANTIATE_TEST_SUITE_P(Forms, StdioState,
                         testing::Values(PbilOptions{}, PbilOptions{0.2, 0.02, MutationForm::Random},
                                         PbilOptions{0.35, 0.0, MutationForm::TowardHalf}));

TEST_P(StdioState, FollowsThePbilFormulaBitForBitOver200Rounds) {
    StdioProtocol session = protocol_of(GetParam());
    base::RandomStream chance(base::Seed{3});
    std::set<std::string> locked;
    json before = json::parse(session.offer());
    for (int round = 1; round <= 200; ++round) {
        ASSERT_EQ(before["round"], round);
        if (round % 10 == 0) {
            const std::string aspect(name_of(kAspects[chance.below(3)]));
            const bool is_locked = !locked.insert(aspect).second && locked.erase(aspect) == 1;
            const std::string same = answer_of(session, json{{is_locked ? "unlock" : "lock", aspect}}.dump());
            ASSERT_EQ(json::parse(same), before) << "a lock changes nothing that is on offer";
        }
        const json pick = json::parse(random_pick(chance))["pick"];
        const json after = json::parse(answer_of(session, json{{"pick", pick}}.dump()));
        for (const Aspect aspect : kAspects) {
            const std::string name(name_of(aspect));
            ASSERT_EQ(after["state"][name].get<std::vector<double>>(),
                      expected_state(before, name, pick, locked.contains(name), GetParam(),
                                     base::Seed{7}.child("mutation").child(round)))
                << name << " after round " << round;
        }
        before = after;
    }
}

TEST(StdioProtocol, GivesTheSameBytesForTheSameSeedAndLines) {
    StdioProtocol first = protocol();
    StdioProtocol second = protocol();
    EXPECT_EQ(first.hello(), second.hello());
    base::RandomStream chance(base::Seed{5});
    for (int i = 0; i < 200; ++i) {
        const std::string line = chance.below(5) == 0 ? R"({"undo":true})" : random_pick(chance);
        ASSERT_EQ(answer_of(first, line), answer_of(second, line));
    }
    EXPECT_NE(protocol_of({}, base::Seed{8}).offer(), protocol().offer());
}

TEST(StdioProtocol, BreedsTheSameBitsOnEveryProcessorAsInItsFirstRelease) {
    // A change of this number means that every kept seed has become another landscape.
    StdioProtocol session = protocol();
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    const auto add = [&](const std::string& text) {
        for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    };
    base::RandomStream chance(base::Seed{1});
    for (int i = 0; i < 50; ++i) {
        const json offer = json::parse(answer_of(session, random_pick(chance)));
        for (const json& candidate : offer["candidates"]) add(candidate["bits"].dump());
        for (const Aspect aspect : kAspects)
            for (const json& p : offer["state"][std::string(name_of(aspect))]) add(fmt::format("{}", p.get<double>()));
    }
    EXPECT_EQ(hash, 6455331851795072805ULL);
}

TEST(StdioProtocol, UndoesToTheSameBytes) {
    StdioProtocol session = protocol();
    const std::string first = session.offer();
    const std::string second = answer_of(session, R"({"pick":{"trees":2,"land":0,"sky":3}})");
    EXPECT_EQ(answer_of(session, R"({"undo":true})"), first);
    EXPECT_EQ(answer_of(session, R"({"pick":{"trees":2,"land":0,"sky":3}})"), second);
}

TEST(StdioProtocol, EndsWithoutALineOnQuit) {
    StdioProtocol session = protocol();
    EXPECT_FALSE(session.answer(R"({"quit":true})").has_value());
}

struct Refused {
    std::string line;
    std::string because;
};

TEST(StdioProtocol, RefusesWhatItDoesNotKnowInOneLineAndGoesOn) {
    StdioProtocol session = protocol();
    const std::string offer = session.offer();
    std::uint64_t line = 0;
    for (const Refused& refused : std::vector<Refused>{
             {R"({"pick":{"trees":7}})", "pick.trees is 7; a candidate is 0, 1, 2 or 3"},
             {R"({"pick":{"sky":-1}})", "pick.sky is -1; a candidate is 0, 1, 2 or 3"},
             {R"({"pick":{"sky":1.5}})", "pick.sky is 1.5; a candidate is 0, 1, 2 or 3"},
             {R"({"pick":{"sky":"1"}})", "pick.sky is \"1\"; a candidate is 0, 1, 2 or 3"},
             {R"({"pick":{"sky":null}})", "pick.sky is null"},
             {R"({"pick":{"sky":18446744073709551615}})", "pick.sky is 18446744073709551615"},
             {R"({"pick":{"sky":1e300}})", "pick.sky is 1e+300"},
             {R"({"pick":{"sky":1e999}})", "not usable JSON"},
             {R"({"pick":{"water":1}})", "pick has the unknown key \"water\"; it knows trees, land, sky"},
             {R"({"pick":{"trees":1,"trees":2}})", "\"trees\" stands twice"},
             {R"({"pick":[2,0,3]})", "pick is a list; it should be an object"},
             {R"({"pick":{"trees":1},"lock":"sky"})", "the line has 2 keys (\"lock\", \"pick\"); write one a line"},
             {R"({"sing":true})", "the key \"sing\" is not known"},
             {R"({"undo":false})", "undo is false; write {\"undo\":true}"},
             {R"({"undo":true})", "nothing to undo in the first round"},
             {R"({"quit":1})", "quit is 1; write {\"quit\":true}"},
             {R"({"lock":"water"})", "lock is \"water\"; an aspect is trees, land or sky"},
             {R"({"unlock":3})", "unlock is 3; an aspect is trees, land or sky"},
             {"", "the line is blank"},
             {" \t\r", "the line is blank"},
             {"{}", "is no request"},
             {"[1]", "is no request"},
             {"NaN", "not JSON"},
             {R"({"pick":)", "not JSON"},
             {"{\"\xff\xfe\":1}", "not JSON"},
             {std::string("\0", 1), "not JSON"},
             {std::string(60'000, '['), "nested deeper than 16 levels"},
             {std::string(10'000'000, 'a'), "longer than 65536 bytes"},
             {"{\"pick\":\"" + std::string(50'000, 'a') + "\"}", "pick is \"aaaa"},
         }) {
        const std::string answer = answer_of(session, refused.line);
        const json error = json::parse(answer);
        SCOPED_TRACE(refused.line.substr(0, 60));
        EXPECT_THAT(answer, StartsWith(R"({"type":"error","line":)"));
        EXPECT_EQ(error["line"], ++line);
        EXPECT_THAT(error["message"].get<std::string>(), HasSubstr(refused.because));
        EXPECT_LT(answer.size(), 400U);
        EXPECT_EQ(answer.find('\n'), std::string::npos);
        EXPECT_EQ(session.offer(), offer);
    }
    EXPECT_THAT(answer_of(session, R"({"pick":{}})"), StartsWith(R"({"type":"offer","round":2)"));
}

TEST(StdioProtocol, SaysHowFarItCanUndo) {
    StdioProtocol session = protocol();
    for (std::size_t i = 0; i <= Session::kUndoDepth; ++i) session.answer(R"({"pick":{}})");
    for (std::size_t i = 0; i < Session::kUndoDepth; ++i) session.answer(R"({"undo":true})");
    EXPECT_THAT(answer_of(session, R"({"undo":true})"), HasSubstr("only the last 1000 rounds are kept"));
}

}  // namespace
}  // namespace quadrat::breeding
