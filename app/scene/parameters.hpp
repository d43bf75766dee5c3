// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "genome/parameter_table.hpp"

namespace quadrat::scene {

// What the growers need, in metres and degrees. Below this no one knows of genes. Ranges: the parameter table.

// A number for each tree row of the parameter table, by the row's id.
struct TreeParameters {
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) float id = standard;
#include "genome/parameters_trees.inc"
#undef PARAMETER
};

// A number for each land row of the parameter table, by the row's id.
struct LandParameters {
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) float id = standard;
#include "genome/parameters_land.inc"
#undef PARAMETER
};

// A number for each sky row of the parameter table, by the row's id.
struct SkyParameters {
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) float id = standard;
#include "genome/parameters_sky.inc"
#undef PARAMETER
};

struct SceneParameters {
    TreeParameters trees;
    LandParameters land;
    SkyParameters sky;
};

SceneParameters realise(const genome::ParameterValues& values);

}  // namespace quadrat::scene
