// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>

#include "genome/recipe.hpp"

namespace quadrat::genome {

// Spring, summer, autumn, winter, as values of tree.season.
inline constexpr std::array<float, 4> kSeasons{0, 1.0F / 3.0F, 2.0F / 3.0F, 1};

// A landscape at another time of the year: its plants by tree.season; leaves that are bred to be gold or red are green
// until autumn; in winter snow comes farther down.
Recipe in_season(Recipe recipe, float season);

// The same landscape in the three other seasons, in the order in which they come after its own.
std::array<Recipe, 3> rest_of_year(const Recipe& recipe);

}  // namespace quadrat::genome
