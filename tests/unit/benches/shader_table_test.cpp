// SPDX-License-Identifier: Apache-2.0
#include "benches/shader_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrat::benches {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kFragment =
    R"({"vertex": "sky.vert", "fragment": "sky.frag", "stage": "fragment", "chip": "4.2",)"
    R"( "instructions": 47, "threads": 4, "spills": 0, "fills": 0, "budget": 49})";
constexpr const char* kBinning = R"({"vertex": "sky.vert", "fragment": "sky.frag", "stage": "binning", "chip": "7.1",)"
                                 R"( "instructions": 12, "threads": 2, "spills": 0, "fills": 0, "budget": null})";

std::string file_of(const std::string& rows) { return R"({"compiler": "Mesa 25.0.7", "shaders": [)" + rows + "]}"; }

std::string with(std::string text, const std::string& what, const std::string& instead) {
    return text.replace(text.find(what), what.size(), instead);
}

std::string refusal_of(const std::string& text) {
    try {
        shader_table_from(text, "shaders.json");
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(ShaderTable, IsReadAsItWasWritten) {
    const ShaderTable table = shader_table_from(file_of(std::string(kFragment) + ",\n" + kBinning), "shaders.json");
    EXPECT_EQ(table.compiler, "Mesa 25.0.7");
    ASSERT_EQ(table.shaders.size(), 2U);
    EXPECT_EQ(table.shaders[0].fragment, "sky.frag");
    EXPECT_EQ(table.shaders[0].instructions, 47);
    EXPECT_EQ(table.shaders[0].budget, 49);
    EXPECT_EQ(table.shaders[1].stage, "binning");
    EXPECT_EQ(table.shaders[1].chip, "7.1");
    EXPECT_FALSE(table.shaders[1].budget);
}

TEST(ShaderTable, NamesTheFileAndThePlaceOfWhatIsWrong) {
    const std::string good = kFragment;
    EXPECT_THAT(refusal_of("V3D 4.2\n"), HasSubstr("shaders.json:1: not JSON"));
    EXPECT_EQ(refusal_of("[]"), "shaders.json: the table is a list; it should be an object");
    EXPECT_EQ(refusal_of(R"({"compiler": "Mesa"})"), "shaders.json: the key shaders is missing");
    EXPECT_EQ(refusal_of(R"({"compiler": "Mesa", "shaders": 3})"), "shaders.json: shaders is 3; it should be a list");
    EXPECT_EQ(refusal_of(file_of(with(good, R"("threads": 4, )", ""))),
              "shaders.json: shaders[0]: the key threads is missing");
    EXPECT_EQ(refusal_of(file_of(std::string(kBinning) + "," + with(good, "47", "\"47\""))),
              "shaders.json: shaders[1]: instructions is \"47\"; it should be a whole number from 0 to 1000000");
    for (const char* wrong : {"-1", "4.5", "1e30", "99999999999", "true", "[]"})
        EXPECT_THAT(refusal_of(file_of(with(good, "47", wrong))), HasSubstr("shaders[0]: instructions is")) << wrong;
    EXPECT_EQ(refusal_of(file_of(with(good, "\"sky.vert\"", "null"))),
              "shaders.json: shaders[0]: vertex is null; it should be a text");
    EXPECT_THAT(refusal_of(file_of(with(good, "\"fragment\",", "\"compute\","))), HasSubstr("stage is \"compute\""));
    EXPECT_THAT(refusal_of(file_of(with(good, "budget", "budgets"))), HasSubstr("has the unknown key \"budgets\""));
    EXPECT_THAT(refusal_of(file_of(good + "," + good)), HasSubstr("shaders[1] has the pair"));
    EXPECT_THAT(refusal_of(file_of("7")), HasSubstr("shaders[0] is 7"));
}

TEST(ShaderTable, MarksWhatNeedsMoreThanItMay) {
    const auto section = [](const std::string& rows) { return section_of(shader_table_from(file_of(rows), "f")); };
    const std::string good = kFragment;
    const std::string fine = section(good + "," + kBinning);
    EXPECT_THAT(fine, HasSubstr("each keeps to its budget"));
    EXPECT_THAT(fine, Not(HasSubstr("breach")));
    for (const auto& [from, to] :
         {std::pair{"47", "50"}, {"\"threads\": 4", "\"threads\": 2"}, {"\"fills\": 0", "\"fills\": 1"}})
        EXPECT_THAT(section(with(good, from, to)), HasSubstr("breach\">1 of 1")) << to;
    EXPECT_THAT(section(""), HasSubstr("<table"));
}

}  // namespace
}  // namespace quadrat::benches
