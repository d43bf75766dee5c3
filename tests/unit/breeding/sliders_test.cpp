// SPDX-License-Identifier: Apache-2.0
#include "breeding/sliders.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "breeding/session.hpp"
#include "breeding/stdio_protocol.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::WordId;
using nlohmann::json;
using testing::HasSubstr;

Session session_of(genome::Genome genome) {
    BreederOptions options;
    options.kind = BreederKind::Sliders;
    options.genome = genome;
    return {Breeder(options), base::Seed{3}};
}

TEST(Sliders, ATurnedWordMovesItsAspectAloneAndChanceStaysAsItWas) {
    Session session = session_of(genome::Genome::Full);
    const genome::Candidate before = session.favourite();
    session.turn("wet", 0.8, "line");
    const genome::Candidate after = session.favourite();
    EXPECT_FLOAT_EQ((*after.words)[WordId::wet], 0.8F);
    EXPECT_EQ(after.seeds, before.seeds);
    EXPECT_NE(after.values[*genome::parameter_named("land.sea_level")],
              before.values[*genome::parameter_named("land.sea_level")]);
    for (const Aspect aspect : {Aspect::Trees, Aspect::Sky})
        for (const auto id : parameters_of(aspect, genome::Genome::Full))
            EXPECT_EQ(after.values[id], before.values[id]) << parameter(id).name;
    EXPECT_EQ(session.offer().round, 2);
}

TEST(Sliders, AParameterFixedByHandStaysWhateverTheWordsDo) {
    Session session = session_of(genome::Genome::Full);
    session.turn("land.sea_level", 0.31, "line");
    session.turn("wet", 1, "line");
    EXPECT_FLOAT_EQ(session.favourite().values[*genome::parameter_named("land.sea_level")], 0.31F);
    session.turn("land.sea_level", std::nullopt, "line");
    EXPECT_EQ(session.favourite().values[*genome::parameter_named("land.sea_level")],
              session.breeder().word_map()(*session.favourite().words)[*genome::parameter_named("land.sea_level")]);
}

TEST(Sliders, APickTurnsTheChosenSliderAndChoosesTheNext) {
    Session session = session_of(genome::Genome::Full);
    session.choose("misty", "line");
    EXPECT_FLOAT_EQ((*session.offer().candidates[0].words)[WordId::misty], -1);
    EXPECT_FLOAT_EQ((*session.offer().candidates[3].words)[WordId::misty], 1);
    genome::Pick pick;
    pick[Aspect::Sky] = 3;
    session.next(pick);
    EXPECT_FLOAT_EQ((*session.favourite().words)[WordId::misty], 1);
    EXPECT_FLOAT_EQ((*session.offer().candidates[0].words)[WordId::misty], 1) << "it stays where it was turned";
    EXPECT_FLOAT_EQ((*session.offer().candidates[0].words)[WordId::stormy], -1);
}

TEST(Sliders, GoStepByStepFromEndToEndAndAllAround) {
    for (const auto genome : {genome::Genome::Classic, genome::Genome::Full}) {
        Session session = session_of(genome);
        const std::size_t count = session.breeder().sliders();
        EXPECT_EQ(count, genome == genome::Genome::Full ? genome::kWordCount : 21U);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(session.breeder().slider(i)->share, 0.5);
            for (const double expected : {0.75, 1.0, 1.0}) {
                session.slide(i, 1);
                EXPECT_EQ(session.breeder().slider(i)->share, expected);
            }
            EXPECT_TRUE(session.undo());
            EXPECT_TRUE(session.undo());
            EXPECT_EQ(session.breeder().slider(i)->share, 0.75);
        }
    }
}

TEST(Sliders, KeepToTheCuratorsRangesAndLocks) {
    Session session = session_of(genome::Genome::Full);
    session.set_range(WordId::wet, {-1, 0.2F});
    session.choose("wet", "line");
    EXPECT_FLOAT_EQ((*session.offer().candidates[3].words)[WordId::wet], 0.2F);
    EXPECT_THROW(session.turn("wet", 0.5, "line"), base::InputError);
    session.set_lock(Aspect::Sky, Lock::Locked);
    EXPECT_THROW(session.turn("misty", 0.5, "line"), base::InputError);
    const genome::Candidate before = session.favourite();
    session.slide(session.breeder().sliders() - 1, 1);
    EXPECT_EQ(*session.favourite().words, *before.words);
}

TEST(Sliders, AreSpokenToLineByLine) {
    StdioProtocol protocol(session_of(genome::Genome::Full));
    const auto answer = [&](std::string_view line) { return json::parse(*protocol.answer(line)); };
    EXPECT_EQ(json::parse(protocol.hello())["breeder"], "sliders");
    const json turned = answer(R"({"turn":{"wet":0.5}})");
    EXPECT_EQ(turned["round"], 2);
    EXPECT_EQ(turned["state"]["land"]["wet"], 0.5);
    EXPECT_EQ(answer(R"({"turn":{"land.sea_level":0.3}})")["candidates"][2]["parameters"]["land.sea_level"], 0.3);
    EXPECT_EQ(answer(R"({"choose":"tall"})")["state"]["chosen"]["trees"], "tall");
    EXPECT_EQ(answer(R"({"undo":true})")["state"]["by_hand"].size(), 1U);
    for (const auto& [line, said] : std::vector<std::pair<std::string, std::string>>{
             {R"({"turn":{"nice":0.5}})", "there is no slider \"nice\""},
             {R"({"turn":{"wet":1.5}})", "wet is 1.5; it should be from -1 to 1"},
             {R"({"turn":{"wet":"high"}})", "it should be a number, or null"},
             {R"({"turn":{"wet":0,"tall":0}})", "one slider"},
             {R"({"turn":{"wet":null}})", "a slider always stands somewhere"},
             {R"({"choose":"land.sea_level"})", "there is no slider"},
             {R"({"choose":3})", "it should be a text"}})
        EXPECT_THAT(answer(line)["message"].get<std::string>(), HasSubstr(said)) << line;
    BreederOptions belief;
    belief.kind = BreederKind::Belief;
    belief.genome = genome::Genome::Full;
    StdioProtocol other(Session(Breeder(belief), base::Seed{1}));
    EXPECT_THAT(*other.answer(R"({"turn":{"wet":0.5}})"), HasSubstr("only sliders can be turned"));
}

}  // namespace
}  // namespace quadrat::breeding
