// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "genome/parameter_table.hpp"
#include "scene/land_parameters.hpp"
#include "scene/sky_parameters.hpp"
#include "scene/tree_parameters.hpp"

namespace quadrat::scene {

// What the growers need, in metres and degrees. Below this no one knows of genes. Ranges: the parameter table.
struct SceneParameters {
    TreeParameters trees;
    LandParameters land;
    SkyParameters sky;
};

SceneParameters realise(const genome::ParameterValues& values);

}  // namespace quadrat::scene
