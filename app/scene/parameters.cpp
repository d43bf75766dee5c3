// SPDX-License-Identifier: Apache-2.0
#include "scene/parameters.hpp"

namespace quadrat::scene {

using P = genome::ParameterId;

SceneParameters realise(const genome::ParameterValues& v) {
    SceneParameters s;
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) s.trees.id = v[P::id];
#include "genome/parameters_trees.inc"
#undef PARAMETER
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) s.land.id = v[P::id];
#include "genome/parameters_land.inc"
#undef PARAMETER
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) s.sky.id = v[P::id];
#include "genome/parameters_sky.inc"
#undef PARAMETER
    return s;
}

}  // namespace quadrat::scene
