// SPDX-License-Identifier: Apache-2.0
#include "scene/parameters.hpp"

#include <cmath>

namespace quadrat::scene {

using P = genome::ParameterId;

SceneParameters realise(const genome::ParameterValues& v) {
    SceneParameters s;
    s.trees.type = static_cast<int>(std::lround(v[P::tree_type]));
    s.trees.branch_angle_deg = v[P::tree_branch_angle_deg];
    s.trees.trunk_contraction = v[P::tree_trunk_contraction];
    s.trees.branch_contraction = v[P::tree_branch_contraction];
    s.trees.leaf_length_m = v[P::tree_leaf_length_m];
    s.trees.spacing_m = v[P::tree_spacing_m];
#define PARAMETER(id, name, unit, min, max, standard, bits, genome, meaning) s.land.id = v[P::id];
#include "genome/parameters_land.inc"
#undef PARAMETER
    s.sky.cloud_scale_m = v[P::cloud_scale_m];
    s.sky.cloud_sharpness = v[P::cloud_sharpness];
    s.sky.sun_elevation_deg = v[P::sun_elevation_deg];
    s.sky.sun_azimuth_deg = v[P::sun_azimuth_deg];
    s.sky.sun_strength = v[P::sun_strength];
    s.sky.sun_warmth = v[P::sun_warmth];
    s.sky.ambient_strength = v[P::ambient_strength];
    s.sky.ambient_warmth = v[P::ambient_warmth];
    s.sky.haze_distance_m = v[P::haze_distance_m];
    s.sky.haze_warmth = v[P::haze_warmth];
    s.sky.sky_depth = v[P::sky_depth];
    return s;
}

}  // namespace quadrat::scene
