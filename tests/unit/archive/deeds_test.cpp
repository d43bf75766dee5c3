// SPDX-License-Identifier: Apache-2.0
#include "archive/deeds.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "genome/scene_code.hpp"

namespace quadrat::archive {
namespace {

TEST(Deeds, AreReadAsTheyWereWritten) {
    Deed whole, part;
    for (const genome::Aspect aspect : genome::kAspects) whole.pick[aspect] = 3;
    part.pick[genome::Aspect::Land] = 0;
    const std::vector<Deed> deeds{whole, part, {}, {{}, SliderStep{12, -1}}, {{}, SliderStep{0, 1}}};
    EXPECT_EQ(to_text(deeds), "DDD -A- --- 12- 0+");
    EXPECT_EQ(deeds_from(to_text(deeds)), deeds);
    EXPECT_EQ(deeds_from(""), std::vector<Deed>{});
}

TEST(Deeds, BeginWithTheLandscapeThatAVisitWasBredOnFrom) {
    const std::string code = genome::code_of(genome::random_recipe(base::Seed{1}));
    genome::Pick pick;
    pick[genome::Aspect::Sky] = 2;
    const std::vector<Deed> deeds = deeds_of(code, {pick, {}});
    EXPECT_EQ(to_text(deeds), "=" + code + " --C ---");
    EXPECT_EQ(deeds_from(to_text(deeds)), deeds);
    EXPECT_EQ(picks_of(deeds), (std::vector<genome::Pick>{pick, {}}));
    EXPECT_EQ(deeds_of("", {pick}).size(), 1U);
}

TEST(Deeds, AreNotReadFromAnythingElse) {
    for (const char* text :
         {"=", "=Q1-", "=ABC", "AB", "ABCD", "ABE", "abc", "7", "7*", "+", "99999999999+", " ABC", "ABC  ABC", "{}"})
        EXPECT_THROW(deeds_from(text), base::InputError) << text;
}

}  // namespace
}  // namespace quadrat::archive
