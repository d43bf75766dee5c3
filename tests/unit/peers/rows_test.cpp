// SPDX-License-Identifier: Apache-2.0
#include "bench/peers/rows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace quadrat::peers {
namespace {

using testing::HasSubstr;

Row row_of(Turns turns) {
    Row row{"chain", "ms", "another library", 0.5};
    row.turns = std::move(turns);
    return row;
}

TEST(PeerRows, QuantilesLieBetweenTheNearestTwo) {
    EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2, 5}, 0.5), 3);
    EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(quantile({1, 2, 3, 4, 5}, 0.25), 2);
    EXPECT_DOUBLE_EQ(quantile({7}, 0.75), 7);
    EXPECT_DOUBLE_EQ(quantile({1, 2}, 2), 2);
    EXPECT_DOUBLE_EQ(quantile({}, 0.5), 0);
}

// The median of the ratios, not the ratio of the medians, which here is 1.
TEST(PeerRows, RatiosAreOfTheSameTurn) {
    const auto ratio = ratio_of({{10, 20, 30}, {20, 40, 10}});
    ASSERT_TRUE(ratio);
    EXPECT_DOUBLE_EQ(ratio->median, 0.5);
    EXPECT_DOUBLE_EQ(ratio->spread, 1.25);
}

TEST(PeerRows, ATurnThatWasSlowForBothIsNotSeen) {
    const auto ratio = ratio_of({{1, 1, 100, 1, 1}, {2, 2, 200, 2, 2}});
    ASSERT_TRUE(ratio);
    EXPECT_DOUBLE_EQ(ratio->median, 0.5);
    EXPECT_DOUBLE_EQ(ratio->spread, 0);
}

TEST(PeerRows, HaveNoRatioWithoutAYardstick) {
    EXPECT_FALSE(ratio_of({{1, 2}, {}}));
    EXPECT_FALSE(ratio_of({{}, {}}));
    EXPECT_FALSE(ratio_of({{1, 2}, {1}}));
    EXPECT_FALSE(ratio_of({{1, 2}, {1, 0}}));
}

TEST(PeerRows, TurnsAlternateAfterOneThatDoesNotCount) {
    std::string order;
    double ours = 0;
    double theirs = 10;
    const Turns turns = in_turns(
        2, [&] { return order += 'o', ++ours; }, [&] { return order += 't', ++theirs; });
    EXPECT_EQ(order, "ototot");
    EXPECT_THAT(turns.ours, testing::ElementsAre(2, 3));
    EXPECT_THAT(turns.yardstick, testing::ElementsAre(12, 13));
    EXPECT_TRUE(in_turns(
                    2, [&] { return ++ours; }, nullptr)
                    .yardstick.empty());
}

TEST(PeerRows, OwnTimeGrowsWithTheWork) {
    volatile double sum = 0;
    const auto work = [&sum](int count) {
        return own_ms([&] {
            for (int i = 0; i < count; ++i) sum = sum + i;
        });
    };
    EXPECT_GT(work(10'000'000), work(1000));
}

TEST(PeerRows, JsonSaysWhatIsKnown) {
    Row missing = row_of({{1, 2, 3}, {}});
    missing.name = "fbm";
    missing.goal.reset();
    missing.why = "built without it";
    const auto json = nlohmann::json::parse(json_of("a machine", {row_of({{1, 2, 3}, {4, 4, 4}}), missing}));
    EXPECT_EQ(json["machine"], "a machine");
    ASSERT_EQ(json["results"].size(), 2U);
    const auto& chain = json["results"][0];
    EXPECT_EQ(chain["name"], "chain");
    EXPECT_EQ(chain["ours"], 2);
    EXPECT_EQ(chain["yardstick"], 4);
    EXPECT_EQ(chain["ratio"], 0.5);
    EXPECT_EQ(chain["spread"], 0.25);
    EXPECT_EQ(chain["goal"], 0.5);
    EXPECT_EQ(chain["turns"], 3);
    EXPECT_FALSE(chain.contains("why"));
    const auto& fbm = json["results"][1];
    EXPECT_EQ(fbm["ours"], 2);
    for (const char* unknown : {"yardstick", "ratio", "spread", "goal"}) EXPECT_TRUE(fbm[unknown].is_null()) << unknown;
    EXPECT_EQ(fbm["why"], "built without it");
}

TEST(PeerRows, TheTableTellsWhichGoalsAreMet) {
    Row missing = row_of({{1}, {}});
    missing.why = "built without it";
    EXPECT_THAT(table_of("a machine", {row_of({{1}, {4}})}), HasSubstr("at most 0.5: met"));
    EXPECT_THAT(table_of("a machine", {row_of({{3}, {4}})}), HasSubstr("at most 0.5: missed"));
    EXPECT_THAT(table_of("a machine", {missing}), HasSubstr("at most 0.5\n    another library\n    built without it"));
}

}  // namespace
}  // namespace quadrat::peers
