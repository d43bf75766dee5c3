// SPDX-License-Identifier: Apache-2.0
#include "benches/peer_table.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrat::benches {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kChain =
    R"({"name": "chain", "ours": 2, "yardstick": 4, "ratio": 0.5, "spread": 0.02, "goal": 0.4, "against": "a <b>")"
    R"(, "turns": 5, "note": "errs less"})";
constexpr const char* kMissing =
    R"({"name": "fbm", "ours": 2, "yardstick": null, "ratio": null, "spread": null, "goal": null, "against": "c")"
    R"(, "why": "built without it"})";

std::string file_of(const std::string& rows) {
    return fmt::format(R"({{"machine": "a machine", "results": [{}]}})", rows);
}

std::string with(std::string text, const std::string& what, const std::string& instead) {
    return text.replace(text.find(what), what.size(), instead);
}

std::string refusal_of(const std::string& text) {
    try {
        peer_table_from(text, "peers.json");
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(PeerTable, IsReadAsItWasWritten) {
    const PeerTable table = peer_table_from(file_of(fmt::format("{},{}", kChain, kMissing)), "peers.json");
    EXPECT_EQ(table.machine, "a machine");
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(table.rows[0].name, "chain");
    EXPECT_EQ(table.rows[0].ratio, 0.5);
    EXPECT_EQ(table.rows[0].spread, 0.02);
    EXPECT_EQ(table.rows[0].goal, 0.4);
    EXPECT_EQ(table.rows[0].note, "errs less");
    EXPECT_FALSE(table.rows[1].ratio);
    EXPECT_EQ(table.rows[1].note, "built without it");
}

TEST(PeerTable, NamesTheFileAndThePlaceOfWhatIsWrong) {
    EXPECT_THAT(refusal_of("chain 1.3\n"), HasSubstr("peers.json:1: not JSON"));
    EXPECT_EQ(refusal_of("[]"), "peers.json: the table is a list; it should be an object");
    EXPECT_EQ(refusal_of(R"({"machine": "m"})"), "peers.json: the key results is missing");
    EXPECT_EQ(refusal_of(R"({"machine": "m", "results": 3})"), "peers.json: results is 3; it should be a list");
    EXPECT_EQ(refusal_of(file_of("7")), "peers.json: results[0] is 7; it should be an object");
    EXPECT_EQ(refusal_of(file_of(with(kChain, R"("spread": 0.02, )", ""))),
              "peers.json: results[0]: the key spread is missing");
    for (const char* wrong : {"-1", "true", "\"0.5\"", "[]"})
        EXPECT_THAT(refusal_of(file_of(with(kChain, "0.5", wrong))), HasSubstr("results[0]: ratio is")) << wrong;
}

TEST(PeerTable, ShowsEachRatioAndWhereAGoalIsMissed) {
    const std::string chain = section_of(peer_table_from(file_of(kChain), "peers.json"));
    for (const char* text : {"a machine", "chain", ">0.5<", ">0.4<", ">missed<", "a &lt;b&gt;; errs less"})
        EXPECT_THAT(chain, HasSubstr(text));
    const std::string missing = section_of(peer_table_from(file_of(kMissing), "peers.json"));
    EXPECT_THAT(missing, HasSubstr("built without it"));
    EXPECT_THAT(missing, Not(HasSubstr("missed")));
}

}  // namespace
}  // namespace quadrat::benches
