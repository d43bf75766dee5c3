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
