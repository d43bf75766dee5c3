// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "genome/parameter_table.hpp"

namespace quadrat::scene {

// What the growers need, in metres and degrees. Below this no one knows of genes. Ranges: the parameter table.

struct TreeParameters {
    int type = 4;  // ABOP fig. 2.6 a to d, then the same made less flat
    float branch_angle_deg = 40;
    float trunk_contraction = 0.88F;
    float branch_contraction = 0.74F;
    float leaf_length_m = 0.46F;
    float spacing_m = 9;
};

struct LandParameters {
    float relief_m = 110;
    float gain = 0.44F;
    float feature_size_m = 420;
    float sea_level = 0.22F;      // share of the land under water
    float erosion = 0.9F;         // how deep streams have cut: 0 not at all
    float erosion_age = 8;        // steps of it on the coarse grid
    float sediment = 0.4F;        // share of what streams carry that they lay where the ground runs flat
    float creep = 0.06F;          // how far the ground between streams has evened out
    float river_area_m2 = 45000;  // drained area from which on a stream is drawn as a river
    float lake_depth_m = 1.2F;    // hollows shallower than this are filled with earth
    float repose_deg = 42;        // the steepest slope that earth keeps
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
