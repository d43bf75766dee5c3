// SPDX-License-Identifier: Apache-2.0
#include "scene/parameters.hpp"

#include "genome/parameter_ids.hpp"

namespace quadrat::scene {

using P = genome::ParameterId;

#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) p.id = v[P::id];

TreeParameters realise_trees(const genome::ParameterValues& v) {
    TreeParameters p;
#include "genome/parameters_trees.inc"
    return p;
}

LandParameters realise_land(const genome::ParameterValues& v) {
    LandParameters p;
#include "genome/parameters_land.inc"
    return p;
}

SkyParameters realise_sky(const genome::ParameterValues& v) {
    SkyParameters p;
#include "genome/parameters_sky.inc"
    return p;
}

#undef PARAMETER

SceneParameters realise(const genome::ParameterValues& values) {
    return {realise_trees(values), realise_land(values), realise_sky(values)};
}

}  // namespace quadrat::scene
