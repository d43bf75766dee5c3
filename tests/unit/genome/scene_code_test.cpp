// SPDX-License-Identifier: Apache-2.0
#include "genome/scene_code.hpp"
#include "genome/parameter_ids.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "base/error.hpp"

namespace quadrat::genome {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

const fs::path kLayouts = QUADRAT_SOURCE_DIR "/app/genome/code_layouts";
const fs::path kKept = QUADRAT_SOURCE_DIR "/tests/unit/genome/codes";

std::string contents_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string error_of(std::string_view code) {
    try {
        recipe_of_code(code, "the code");
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(SceneCode, ComesBackWithinHalfAStepAndItsSeedsKindsAndCountsExactly) {
    for (std::uint64_t i = 0; i < 300; ++i) {
        const Recipe recipe = random_recipe(base::Seed{i});
        const Recipe back = recipe_of_code(code_of(recipe), "test");
        EXPECT_EQ(back.seeds, recipe.seeds);
        EXPECT_EQ(back.flight, recipe.flight);
        for (const Parameter& p : parameter_table()) {
            const bool is_whole = p.unit.empty() || p.unit == kChoice;
            const float half_a_step = is_whole ? 0 : (p.max - p.min) / 255 / 2 * 1.001F;
            ASSERT_NEAR(back.values[p.id], recipe.values[p.id], half_a_step) << p.name;
        }
        ASSERT_EQ(code_of(back), code_of(recipe)) << "and is the same code again";
    }
}

TEST(SceneCode, OfRoundedValuesIsExact) {
    for (std::uint64_t i = 0; i < 300; ++i) {
        Recipe recipe = random_recipe(base::Seed{i});
        recipe.values = rounded_for_code(recipe.values);
        ASSERT_EQ(recipe_of_code(code_of(recipe), "test"), recipe);
        ASSERT_EQ(rounded_for_code(recipe.values), recipe.values);
    }
}

std::string begins_with(std::size_t version) { return fmt::format("Q{}-", version); }

TEST(SceneCode, KeepsTheEndsOfEveryRangeExactly) {
    for (const bool is_greatest : {false, true}) {
        Recipe recipe;
        for (const Parameter& p : parameter_table()) recipe.values.set(p.id, is_greatest ? p.max : p.min);
        EXPECT_EQ(recipe_of_code(code_of(recipe), "test"), recipe);
    }
}

TEST(SceneCode, IsShortAndOfLettersThatAQrCodePacksAndAnAddressBears) {
    const std::string code = code_of(random_recipe(base::Seed{3}));
    EXPECT_LE(code.size(), 620U);
    EXPECT_EQ(code.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ234567-1890"), std::string::npos);
    EXPECT_EQ(code.substr(0, 3), begins_with(code_layouts().size()));
}

TEST(SceneCode, IsReadInSmallLettersAndBehindAnAddress) {
    const Recipe recipe = recipe_of_code(code_of(random_recipe(base::Seed{5})), "test");
    const std::string code = code_of(recipe);
    std::string small = code;
    for (char& c : small) c = static_cast<char>(std::tolower(c));
    for (const std::string& text :
         {code, small, "https://museum.example/quadrat/" + code, "https://a-b.example/q?c=" + code})
        EXPECT_EQ(recipe_of_code(text, "test"), recipe) << text;
}

TEST(SceneCode, EveryLetterIsUnderTheChecksum) {
    const std::string code = code_of(random_recipe(base::Seed{9}));
    for (std::size_t at = 3; at < code.size(); ++at) {
        std::string wrong = code;
        wrong[at] = wrong[at] == 'A' ? 'B' : 'A';
        EXPECT_THAT(error_of(wrong), HasSubstr("is not as it was written")) << at;
    }
    for (std::size_t at = 3; at + 1 < code.size(); ++at) {
        std::string swapped = code;
        std::swap(swapped[at], swapped[at + 1]);
        if (swapped != code) {
            EXPECT_THAT(error_of(swapped), HasSubstr("is not as it was written")) << at;
        }
    }
}

TEST(SceneCode, SaysWhatIsWrongWithAnythingElse) {
    const std::string code = code_of(Recipe{});
    EXPECT_THAT(error_of(""), HasSubstr("the code: this is no scene code; one begins with Q, a number and a hyphen"));
    EXPECT_THAT(error_of("Q1-ABC"), HasSubstr("no scene code"));
    EXPECT_THAT(error_of(code.substr(1)), HasSubstr("no scene code"));
    EXPECT_THAT(error_of(code.substr(0, code.size() - 1)), HasSubstr("letters behind the hyphen; it should have"));
    EXPECT_THAT(error_of(code + "A"), HasSubstr("letters behind the hyphen; it should have"));
    const std::size_t newest = code_layouts().size();
    EXPECT_THAT(
        error_of(begins_with(newest + 1) + code.substr(3)),
        HasSubstr(fmt::format("the code is of version {}; this program reads versions 1 to {}", newest + 1, newest)));
    EXPECT_THAT(error_of("Q0" + code.substr(2)), HasSubstr("version 0"));
    EXPECT_THAT(error_of("Q99999999999999999999" + code.substr(2)), HasSubstr("this program reads"));
    EXPECT_THAT(error_of(code + "1"), HasSubstr("no scene code")) << "1 is no letter of base 32";
}

TEST(SceneCode, HasNoRoomForAnythingButTheScene) {
    std::size_t bits = 4 * 64;
    for (const CodeField& field : code_layouts().back()) bits += static_cast<std::size_t>(field.bits);
    const std::size_t bytes = (bits + 7) / 8 + 4;
    EXPECT_EQ(code_of(random_recipe(base::Seed{4})).size(), std::string_view("Q1-").size() + (8 * bytes + 4) / 5);
}

// A program with a new gene writes codes of a new version, and still reads those of before.
TEST(SceneCode, OfAnOlderProgramGivesNewParametersTheirDefaultsAndLeavesOutWhatHasGone) {
    CodeLayout old = code_layouts().back();
    std::erase_if(old, [](const CodeField& field) { return field.name == "cloud.cover" || field.name == "tree.type"; });
    old.insert(old.begin() + 7, CodeField{"tree.forgotten", 0, 5, 3, true});
    const std::vector<CodeLayout> then{old}, now{old, layout_of_the_table()};
    const Recipe recipe = random_recipe(base::Seed{11});
    const std::string code = code_of(recipe, then);
    const Recipe read = recipe_of_code(code, "test", now);
    // As a scene file of that program is read: what it leaves out has its default.
    Recipe expected = recipe_of_code(code_of(recipe), "test");
    expected.values.set(ParameterId::cloud_cover, parameter(ParameterId::cloud_cover).default_value);
    expected.values.set(ParameterId::tree_type, parameter(ParameterId::tree_type).default_value);
    EXPECT_EQ(read, expected);
    EXPECT_EQ(code_of(read, now).substr(0, 3), "Q2-") << "of two layouts the second";
    EXPECT_EQ(code_of(recipe_of_code(code_of(read, now), "test", now), now), code_of(read, now));
}

TEST(SceneCode, OfAProgramWithAnotherRangeMeansTheSameValueAsFarAsTheRangeOfNowReaches) {
    CodeLayout other = code_layouts().front();
    const auto depth = std::ranges::find(other, "sky.depth", &CodeField::name);
    ASSERT_NE(depth, other.end());
    depth->max = 4;
    const std::vector<CodeLayout> then{other};
    Recipe recipe;
    recipe.values.set(ParameterId::sky_depth, 0.5F);
    EXPECT_NEAR(recipe_of_code(code_of(recipe, then), "test", then).values[ParameterId::sky_depth], 0.5, 2.01 / 255);
    recipe.values.set(ParameterId::sky_depth, 1);
    EXPECT_LE(recipe_of_code(code_of(recipe, then), "test", then).values[ParameterId::sky_depth], 1);
}

// A change of the parameter table needs a new version; the old ones stay, for codes of every version are out there.
TEST(SceneCode, IsWrittenInTheLayoutOfTheParameterTableOfNow) {
    if (std::getenv("QUADRAT_MAKE_GOLDENS") != nullptr && code_layouts().back() != layout_of_the_table()) {
        const std::size_t version = code_layouts().size() + 1;
        std::ofstream out(kLayouts / (std::to_string(version) + ".txt"));
        out << "# Parameters as a scene code of version " << version
            << " holds them: name, range, bits, and whether it is whole. Never changed.\n"
            << to_text(layout_of_the_table());
        GTEST_SKIP() << "layout " << version << " is written; build again";
    }
    EXPECT_EQ(to_text(code_layouts().back()), to_text(layout_of_the_table()))
        << "codes need a new version: QUADRAT_MAKE_GOLDENS=1 writes its layout";
}

// Codes that were written once: of each version one, with the scene that it was.
TEST(SceneCode, OfEveryVersionIsReadAsItWasKept) {
    for (std::size_t version = 1; version <= code_layouts().size(); ++version) {
        const fs::path file = kKept / (std::to_string(version) + ".json");
        if (std::getenv("QUADRAT_MAKE_GOLDENS") != nullptr && !fs::exists(file)) {
            const std::string code = code_of(random_recipe(base::Seed{2026}));
            fs::create_directories(kKept);
            std::ofstream(kKept / (std::to_string(version) + ".code")) << code << "\n";
            std::ofstream(file) << to_json(recipe_of_code(code, "test")) << "\n";
        }
        std::string code = contents_of(kKept / (std::to_string(version) + ".code"));
        ASSERT_FALSE(code.empty()) << version;
        code.pop_back();
        EXPECT_EQ(recipe_of_code(code, "kept"), from_json(contents_of(file), file.string())) << version;
    }
}

}  // namespace
}  // namespace quadrat::genome
