// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quadrat::genome {
class ParameterValues;
}

namespace quadrat::scene {

// A number for each tree row of the parameter table, by the row's id.
struct TreeParameters {
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) float id = standard;
#include "genome/parameters_trees.inc"
#undef PARAMETER
};
TreeParameters realise_trees(const genome::ParameterValues& values);

}  // namespace quadrat::scene
