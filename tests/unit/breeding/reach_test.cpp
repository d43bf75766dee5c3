// SPDX-License-Identifier: Apache-2.0
#include "breeding/reach.hpp"

#include <gtest/gtest.h>

#include <set>

namespace quadrat::breeding {
namespace {

BreederOptions default_breeder() {
    BreederOptions options;
    options.kind = BreederKind::Belief;
    options.genome = genome::Genome::Full;
    return options;
}

const Reach& found() {
    static const Reach kFound = reach_of(default_breeder());
    return kFound;
}

// A parameter that no pick moves is no gene: it belongs into the code.
TEST(Reach, NoParameterStandsStill) {
    for (const ParameterReach& p : found().parameters) EXPECT_GT(p.share(), 0.05) << parameter(p.id).name;
}

TEST(Reach, NineInTenReachHalfOfTheirRangeAndTheMedianFourFifths) {
    EXPECT_GE(found().share_reaching(0.5), 0.9) << text_of(found(), false);
    EXPECT_GE(found().median_share(), 0.8);
}

TEST(Reach, EveryKindIsInAHundredthOfTheOffers) {
    for (const KindReach& kind : found().kinds) EXPECT_GE(kind.offers, 0.01) << kind.name;
}

TEST(Reach, TwoOfAFirstOfferDifferInTheMeanByThirtyHundredths) { EXPECT_GE(found().difference, 0.30); }

TEST(Reach, NamesEveryKindThatThereIsOnce) {
    std::set<std::string> names;
    for (const KindReach& kind : found().kinds) EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    for (const char* one :
         // The book's own four and the four changed, its ternary tree, the two kinds that colonise space, and the three
         // that organise themselves.
         {"tree.type 0, grown", "tree.type 3, grown", "tree.type 4, grown", "tree.type 7, grown", "tree.habit 12",
          "tree.habit 9", "tree.habit 10", "tree.habit 15", "tree.habit 16", "tree.habit 17", "tree.habit 18",
          "ground.country 5", "arch.share on", "bow.strength on", "site.share on, wild"})
        EXPECT_EQ(names.count(one), 1U) << one;
}

// Only so can it fail: what is locked is found to stand still.
TEST(Reach, FindsWhatACuratorHoldsStill) {
    BreederOptions options = default_breeder();
    for (const genome::Word& word : genome::vocabulary()) options.ranges[static_cast<std::size_t>(word.id)] = {0, 0};
    const Reach held = reach_of(options, {4, 2});
    EXPECT_LT(held.median_share(), 0.6);
    EXPECT_LT(held.median_share(), reach_of(default_breeder(), {4, 2}).median_share());
    EXPECT_NE(text_of(held, false).find("of a range"), std::string::npos);
}

}  // namespace
}  // namespace quadrat::breeding
