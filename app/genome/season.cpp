// SPDX-License-Identifier: Apache-2.0
#include "genome/season.hpp"

#include <algorithm>
#include <cmath>

#include "genome/parameter_ids.hpp"
#include "genome/parameter_rules.hpp"

namespace quadrat::genome {
namespace {

constexpr int kSummerPalette = 1;  // of tree.palette
constexpr int kAutumnPalette = 4;

}  // namespace

Recipe in_season(Recipe recipe, float season) {
    constexpr float kFallsBy = 0.6F;  // the snow line, of the highest ground, from summer to winter
    constexpr float kWinterBegins = 0.7F;
    ParameterValues& values = recipe.values;
    const auto cold = [](float at) { return std::clamp((at - kWinterBegins) / (1 - kWinterBegins), 0.0F, 1.0F); };
    const Parameter& line = parameter(ParameterId::ground_snow_line);
    const float warmer = cold(values[ParameterId::tree_season]) - cold(season);
    values.set(line.id, std::clamp(values[line.id] + kFallsBy * warmer, line.min, line.max));
    values.set(ParameterId::tree_season, season);
    // Leaves that are bred to be gold or red have turned in autumn: until then they are green.
    const float turned = std::clamp(3 * season - 1, 0.0F, 1.0F);
    for (const ParameterId id : {ParameterId::tree_autumn, ParameterId::second_autumn, ParameterId::third_autumn})
        values.set(id, turned * values[id]);
    if (turned == 0 && std::lround(values[ParameterId::tree_palette]) == kAutumnPalette)
        values.set(ParameterId::tree_palette, kSummerPalette);
    make_consistent(Aspect::Trees, values);
    make_consistent(Aspect::Land, values);
    return recipe;
}

std::array<Recipe, 3> rest_of_year(const Recipe& recipe) {
    const float own = recipe.values[ParameterId::tree_season];
    const auto nearest = static_cast<std::size_t>(std::lround(3 * std::clamp(own, 0.0F, 1.0F)));
    const auto after = [&](std::size_t by) { return in_season(recipe, kSeasons[(nearest + by) % kSeasons.size()]); };
    return {after(1), after(2), after(3)};
}

}  // namespace quadrat::genome
