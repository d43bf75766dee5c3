// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <utility>

#include "journeys/quadrat_program.hpp"

namespace {

using namespace quadrat::tests;

// Fast, diverse, easy, each with how it is measured.
TEST(Bench, TellsWhatASystemIsWorth) {
    const TemporaryFolder folder;
    const Ended ended = run(program({"bench", "worth", "--json", "--report", "worth.html"}), folder);
    ASSERT_EQ(ended.status, 0) << ended.err;
    std::map<std::string, double> values;
    const auto json = nlohmann::json::parse(ended.out);
    for (const auto& result : json["results"]) values[result["name"]] = result["value"];
    EXPECT_GT(values.at("worth.fastest_scene_ms"), 0);
    EXPECT_GT(values.at("worth.diverse_parameters"), 0.2);
    EXPECT_GT(values.at("worth.diverse_pictures"), 0.02);
    EXPECT_LT(values.at("worth.easy_rounds"), values.at("worth.easy_rounds_by_sliders"));
    EXPECT_NE(contents_of(folder / "worth.html").find("easiest to come to a wish"), std::string::npos);
}

TEST(Bench, LeavesAReportInOnePage) {
    const TemporaryFolder folder;
    folder.write("shaders.json", R"({"compiler": "Mesa 25.0.7", "shaders": [{"vertex": "sky.vert", "fragment":
        "sky.frag", "stage": "fragment", "chip": "4.2", "instructions": 47, "threads": 4, "spills": 0, "fills": 0,
        "budget": 49}]})");
    folder.write("peers.json", R"({"machine": "another", "results": [{"name": "chain", "ours": 2, "yardstick": 4,
        "ratio": 0.5, "spread": 0.01, "goal": 0.95, "against": "meshoptimizer"}]})");
    ASSERT_TRUE(succeeds(run(
        program({"bench", "generation", "--report", "x.html", "--shaders", "shaders.json", "--peers", "peers.json"}),
        folder)));
    const std::string page = contents_of(folder / "x.html");
    for (const char* text :
         {"<!DOCTYPE html>", "generation.cold_ms", "sky.frag", "Mesa 25.0.7", "id=\"peers\"", "</html>"})
        EXPECT_NE(page.find(text), std::string::npos) << text;
    EXPECT_EQ(count_of(page, "http"), 0U) << "it needs nothing from outside";
}

TEST(Bench, RefusesBeforeItMeasuresWhatItCouldNotReportAfterwards) {
    const TemporaryFolder folder;
    folder.write("shaders.json", R"({"compiler": "Mesa", "shaders": [{"vertex": 3}]})");
    const std::vector<std::pair<std::vector<std::string>, std::string>> refused{
        {{"--report", "no/such/folder/x.html"}, "no/such/folder/x.html: there is no folder"},
        {{"--plot", "no/such/folder/x.svg"}, "no/such/folder/x.svg: there is no folder"},
        {{"--report", "."}, ".: is a directory"},
        {{"--report", "x.html", "--shaders", "shaders.json"}, "shaders.json: shaders[0]: vertex is 3"},
        {{"--report", "x.html", "--shaders", "none.json"}, "none.json: cannot read"},
        {{"--report", "x.html", "--peers", "shaders.json"}, "shaders.json: the key machine is missing"},
        {{"--peers", "shaders.json"}, "--report"},
        {{"--shaders", "shaders.json"}, "--report"}};
    for (const auto& [options, said] : refused) {
        std::vector<std::string> arguments{"bench", "generation"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Ended ended = run(program(arguments), folder);
        EXPECT_TRUE(ends_with(ended, 2)) << said;
        EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
        EXPECT_EQ(lines_of(ended.err).size(), 1U) << "one line, and nothing measured: " << ended.err;
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "x.html"));
}

}  // namespace
