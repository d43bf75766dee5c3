// SPDX-License-Identifier: Apache-2.0
// Somebody who wants just a roof, just lots, just a façade.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "journeys/quadrat_program.hpp"

namespace {

using namespace quadrat::tests;
using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kPlan =
    R"({"outer": [[0, 0], [8, 0], [8, 5], [4, 5], [4, 8], [0, 8]], "weights": [45, 90, 45, 45, 90, 45]})";

TEST(Skeleton, RoofsAPlanInEveryFormat) {
    const TemporaryFolder folder;
    folder.write("plan.json", kPlan);
    const Ended printed = run(program({"skeleton", "plan.json"}), folder);
    ASSERT_TRUE(succeeds(printed));
    const json roof = json::parse(printed.out);
    EXPECT_EQ(roof["faces"].size(), 6U);
    for (const json& face : roof["faces"]) EXPECT_GE(face["vertices"].size(), 3U);
    for (const std::string name : {"roof.json", "roof.svg", "roof.obj", "roof.glb", "roof.gltf"})
        EXPECT_TRUE(succeeds(run(program({"skeleton", "plan.json", "-o", name}), folder))) << name;
    EXPECT_EQ(contents_of(folder / "roof.json"), printed.out);
    EXPECT_EQ(count_of(contents_of(folder / "roof.svg"), "<path"), 4U) << "two of six faces stand upright";
    EXPECT_THAT(contents_of(folder / "roof.obj"), HasSubstr("\nf "));
}

TEST(Skeleton, SaysWhichEdgesCross) {
    const TemporaryFolder folder;
    folder.write("bow.json", R"({"outer": [[0, 0], [2, 2], [2, 0], [0, 2]]})");
    const Ended ended = run(program({"skeleton", "bow.json", "-o", "roof.svg"}), folder);
    EXPECT_TRUE(ends_with(ended, 2));
    EXPECT_THAT(ended.err, HasSubstr("bow.json: edges 0 and 2 cross"));
    EXPECT_FALSE(std::filesystem::exists(folder / "roof.svg"));
    folder.write("few.json", R"({"outer": [[0, 0], [2, 2], [2, 0]], "weights": [45]})");
    EXPECT_THAT(run(program({"skeleton", "few.json"}), folder).err,
                HasSubstr("few.json: weights is a list of 3 slopes"));
}

TEST(Lots, AreDividedAndDrawn) {
    const TemporaryFolder folder;
    folder.write("region.json", R"({"outer": [[0, 0], [300, 0], [320, 200], [0, 240]]})");
    const Ended printed =
        run(program({"lots", "region.json", "--blocks", "12", "--uneven", "0.6", "--seed", "3"}), folder);
    ASSERT_TRUE(succeeds(printed));
    const json town = json::parse(printed.out);
    EXPECT_GT(town["lots"].size(), 30U);
    for (const json& lot : town["lots"]) EXPECT_FALSE(lot["street_edges"].empty());
    ASSERT_TRUE(succeeds(run(program({"lots", "region.json", "-o", "town.svg"}), folder)));
    EXPECT_THAT(contents_of(folder / "town.svg"), HasSubstr("</svg>"));
    folder.write("bent.json", R"({"outer": [[0, 0], [50, 50], [100, 0], [100, 100], [0, 100]]})");
    const Ended bent = run(program({"lots", "bent.json"}), folder);
    ASSERT_TRUE(succeeds(bent)) << "with a bay";
    EXPECT_GT(json::parse(bent.out)["lots"].size(), 5U);
    folder.write("bow.json", R"({"outer": [[0, 0], [200, 200], [200, 0], [0, 200]]})");
    const Ended crossed = run(program({"lots", "bow.json"}), folder);
    EXPECT_TRUE(ends_with(crossed, 2));
    EXPECT_THAT(crossed.err, HasSubstr("bow.json: edges 0 and 2 cross"));
}

TEST(Facade, IsDerivedFromAFileOrAHouseType) {
    const TemporaryFolder folder;
    const Ended listed = run(program({"facade", "--list"}), folder);
    ASSERT_TRUE(succeeds(listed));
    EXPECT_GE(lines_of(listed.out).size(), 8U);
    ASSERT_TRUE(succeeds(
        run(program({"facade", "alpine", "-o", "a.svg", "--width", "9", "--height", "5", "--gable", "3"}), folder)));
    EXPECT_GT(count_of(contents_of(folder / "a.svg"), "<rect"), 50U);
    ASSERT_TRUE(succeeds(run(program({"facade", "barn", "-o", "b.obj"}), folder)));
    folder.write("own.facade", "Facade -> panel #aabbcc with A\nA -> repeat x 2 B\nB -> panel #112233 depth -0.1\n");
    ASSERT_TRUE(succeeds(run(program({"facade", "own.facade", "-o", "own.svg"}), folder)));
    folder.write("bad.facade", "Facade -> split x 1r Wall\n");
    const Ended bad = run(program({"facade", "bad.facade", "-o", "c.svg"}), folder);
    EXPECT_TRUE(ends_with(bad, 2));
    EXPECT_THAT(bad.err, HasSubstr("bad.facade:1:22: no rule says what becomes of Wall"));
}

}  // namespace
