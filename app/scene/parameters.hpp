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

struct SkyParameters {
    float cloud_scale_m = 1400;
    float cloud_sharpness = 0.5F;
    float sun_elevation_deg = 28;
    float sun_azimuth_deg = 60;  // clockwise from north
    float sun_strength = 1;
    float sun_warmth = 0.35F;
    float ambient_strength = 0.95F;
    float ambient_warmth = -0.2F;
    float haze_distance_m = 1700;
    float haze_warmth = 0.2F;
    float sky_depth = 0.6F;
};

struct SceneParameters {
    TreeParameters trees;
    LandParameters land;
    SkyParameters sky;
};

SceneParameters realise(const genome::ParameterValues& values);

}  // namespace quadrat::scene
