// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quadrat::genome {
class ParameterValues;
}

namespace quadrat::scene {

// A number for each land row of the parameter table, by the row's id.
struct LandParameters {
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) float id = standard;
#include "genome/parameters_land.inc"
#undef PARAMETER
};
LandParameters realise_land(const genome::ParameterValues& values);

}  // namespace quadrat::scene
