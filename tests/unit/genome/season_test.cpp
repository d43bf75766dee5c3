// SPDX-License-Identifier: Apache-2.0
#include "genome/season.hpp"

#include <gtest/gtest.h>

#include "genome/parameter_ids.hpp"
#include "genome/parameter_rules.hpp"

namespace quadrat::genome {
namespace {

using P = ParameterId;

TEST(Season, TheRestOfAYearComesInItsOrder) {
    Recipe recipe = random_recipe(base::Seed{4});
    for (std::size_t own = 0; own < kSeasons.size(); ++own) {
        recipe.values.set(P::tree_season, kSeasons[own]);
        const auto rest = rest_of_year(recipe);
        for (std::size_t i = 0; i < rest.size(); ++i)
            EXPECT_FLOAT_EQ(rest[i].values[P::tree_season], kSeasons[(own + 1 + i) % 4]);
    }
}

TEST(Season, TurnsLeavesInAutumnAndNotBefore) {
    Recipe recipe = random_recipe(base::Seed{6});
    recipe.values.set(P::tree_season, kSeasons[2]);
    recipe.values.set(P::tree_palette, 4);
    for (const P id : {P::tree_autumn, P::second_autumn, P::third_autumn}) recipe.values.set(id, 0.8F);
    for (const float season : {kSeasons[0], kSeasons[1]}) {
        const Recipe green = in_season(recipe, season);
        for (const P id : {P::tree_autumn, P::second_autumn, P::third_autumn}) EXPECT_EQ(green.values[id], 0);
        EXPECT_EQ(green.values[P::tree_palette], 1);
    }
    EXPECT_EQ(in_season(recipe, kSeasons[2]).values, recipe.values);
    EXPECT_EQ(in_season(recipe, kSeasons[3]).values[P::tree_autumn], 0.8F) << "those that still hang";
}

TEST(Season, ChangesPlantsAndSnowAndNothingElse) {
    Recipe recipe = random_recipe(base::Seed{5});
    recipe.values.set(P::tree_season, kSeasons[1]);
    recipe.values.set(P::ground_snow_line, 1.4F);
    recipe.values.set(P::land_sea_level, 0.1F);
    make_consistent(Aspect::Land, recipe.values);
    const Recipe winter = in_season(recipe, 1);
    EXPECT_NEAR(winter.values[P::ground_snow_line], 0.8F, 1e-5F);
    EXPECT_EQ(winter.seeds, recipe.seeds);
    EXPECT_EQ(winter.flight, recipe.flight);
    for (const Parameter& p : parameter_table()) {
        if (p.id == P::tree_season || p.id == P::ground_snow_line) continue;
        EXPECT_EQ(winter.values[p.id], recipe.values[p.id]) << p.name;
    }
    EXPECT_NEAR(in_season(winter, kSeasons[1]).values[P::ground_snow_line], 1.4F, 1e-5F) << "and it melts";
    EXPECT_EQ(in_season(recipe, kSeasons[2]).values[P::ground_snow_line], 1.4F) << "none falls in autumn";
}

}  // namespace
}  // namespace quadrat::genome
