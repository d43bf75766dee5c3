// SPDX-License-Identifier: Apache-2.0
#include "synthesis/houses/facade.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "base/error.hpp"

namespace quadrat::synthesis::houses {
namespace {

using testing::HasSubstr;

std::vector<FacadePanel> derived(const std::string& text, const FacadeShape& shape = {}, std::uint64_t seed = 1) {
    return derive_facade(read_facade(text, "t"), shape, base::Seed{seed});
}

std::string complaint(const std::string& text) {
    try {
        derived(text);
    } catch (const base::InputError& error) {
        return error.what();
    }
    return {};
}

TEST(Facade, SharesWhatAbsoluteSizesLeave) {
    const auto panels = derived("Facade -> split x 2 A, 1r A, 2r A\nA -> panel #102030", {8, 6, 0, {}});
    ASSERT_EQ(panels.size(), 3U);
    EXPECT_NEAR(panels[0].high_m.x, 2, 1e-12);
    EXPECT_NEAR(panels[1].high_m.x, 4, 1e-12);
    EXPECT_NEAR(panels[2].high_m.x, 8, 1e-12);
    EXPECT_NEAR(panels[0].colour.b, 48 / 255.0, 1e-6);
}

TEST(Facade, RepeatsAWholeNumberOfTimes) {
    const auto panels =
        derived("set bay = 1.5 + width / 16\nFacade -> repeat x bay A\nA -> panel #102030", {8, 6, 0, {}});
    ASSERT_EQ(panels.size(), 4U);
    for (const FacadePanel& panel : panels) EXPECT_NEAR(panel.high_m.x - panel.low_m.x, 2, 1e-12);
}

TEST(Facade, DividesAtMarkedLinesWhereItSnaps) {
    const std::string text =
        "Facade -> split y 1r Lower, 1r Upper\nLower -> split x mark 3 Nothing, 1r Nothing\n"
        "Upper -> repeat x 2 A snap\nA -> panel #102030\nNothing -> nothing";
    std::set<double> ends;
    for (const FacadePanel& panel : derived(text, {8, 6, 0, {}})) ends.insert(panel.low_m.x);
    EXPECT_TRUE(ends.contains(3.0));
}

TEST(Facade, HasItsDoorOnTheFrontAlone) {
    const std::string text =
        "Facade when front < 1 -> repeat x 2 Bay\nFacade -> split x 1r Nothing, 1 Door, 1r Nothing\n"
        "Bay -> panel #102030\nDoor -> panel #405060\nNothing -> nothing";
    const auto front = derived(text, {8, 4, 0, {}, true});
    ASSERT_EQ(front.size(), 1U);
    EXPECT_EQ(front.front().symbol, "Door");
    EXPECT_EQ(derived(text, {8, 4, 0, {}, false}).size(), 4U);
}

TEST(Facade, LeavesOutWhatARoofOrANeighbourCovers) {
    const std::string text =
        "Facade -> repeat y 1 Row\nRow -> repeat x 1 Bay\nBay -> free Window\nWindow -> panel #102030";
    FacadeShape gabled{8, 2, 4, {}};
    for (const FacadePanel& panel : derived(text, gabled)) {
        EXPECT_LE(panel.high_m.y, 2 + 4 * (1 - std::abs(panel.low_m.x - 4) / 4) + 1e-9);
        EXPECT_LE(panel.high_m.y, 2 + 4 * (1 - std::abs(panel.high_m.x - 4) / 4) + 1e-9);
    }
    const std::size_t alone = derived(text, {8, 4, 0, {}}).size();
    const std::size_t beside = derived(text, {8, 4, 0, {{{0, 0}, {1.5, 2.5}}}}).size();
    EXPECT_EQ(alone, 32U);
    EXPECT_EQ(beside, 32U - 2 * 3);
}

TEST(Facade, DrawsAChoiceOnceForAHouse) {
    const std::string text = "choose c = #ff0000 1 | #00ff00 1\nFacade -> repeat x 0.5 A\nA -> panel c";
    std::set<float> over_seeds;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        std::set<float> within;
        for (const FacadePanel& panel : derived(text, {}, seed)) within.insert(panel.colour.r);
        EXPECT_EQ(within.size(), 1U);
        over_seeds.insert(*within.begin());
    }
    EXPECT_EQ(over_seeds.size(), 2U);
}

TEST(Facade, NamesTheLineAndColumnOfAMistake) {
    EXPECT_THAT(complaint("Facade -> spilt x 1 A"), HasSubstr("t:1:11: spilt is none of"));
    EXPECT_THAT(complaint("\nFacade -> split z 1 A"), HasSubstr("t:2:17: x or y is meant"));
    EXPECT_THAT(complaint("Facade -> split x 1 A"), HasSubstr("t:1:21: no rule says what becomes of A"));
    EXPECT_THAT(complaint("Facade -> panel red"), HasSubstr("t:1:17: red is neither"));
    EXPECT_THAT(complaint("Facade -> panel #ff0000 depth d"), HasSubstr("t:1:31: d is set nowhere"));
    EXPECT_THAT(complaint("Facade -> split x 1 Facade"), HasSubstr("goes on for ever"));
    EXPECT_THAT(complaint("Facade when width > 99 -> nothing"), HasSubstr("no rule for Facade holds"));
    EXPECT_THAT(complaint("Facade -> repeat x 0.005 A\nA -> repeat y 0.005 B\nB -> panel #ffffff"),
                HasSubstr("t:3:1: more than"));
    EXPECT_THAT(complaint("Facade -> split x 1r Facade, 1r Facade"), HasSubstr("more than 400000 shapes"));
    EXPECT_THAT(complaint("set a = 1 / 0\nFacade -> nothing"), HasSubstr("t:1:11: this divides by 0"));
    EXPECT_THAT(complaint("Facade -> nothing more"), HasSubstr("t:1:19: nothing more is meant here"));
}

TEST(Facade, DerivesEveryHouseTypeAtManySizes) {
    EXPECT_GE(facade_library().size(), 8U);
    for (const NamedFacade& type : facade_library()) {
        const FacadeGrammar grammar = read_facade(type.text, type.name);
        EXPECT_FALSE(grammar.name.empty()) << type.name;
        for (const double width : {2.5, 5.0, 9.0, 16.0})
            for (const double height : {2.2, 4.0, 7.5, 14.0})
                for (const double gable : {0.0, 2.0}) {
                    const auto panels = derive_facade(grammar, {width, height, gable, {}}, base::Seed{3});
                    EXPECT_GE(panels.size(), 2U) << type.name << " " << width << " by " << height;
                    const mesh::Model model = facade_model(panels);
                    EXPECT_FALSE(model.parts.empty());
                }
    }
}

}  // namespace
}  // namespace quadrat::synthesis::houses
