// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quadrat::genome {
class ParameterValues;
}

namespace quadrat::scene {

// A number for each sky row of the parameter table, by the row's id.
struct SkyParameters {
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) float id = standard;
#include "genome/parameters_sky.inc"
#undef PARAMETER
};
SkyParameters realise_sky(const genome::ParameterValues& values);

}  // namespace quadrat::scene
