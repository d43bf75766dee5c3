#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The country around the land, to the horizon.
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/cloud_shadow.glsl"
#include "common/lit_ground.glsl"
#include "common/grid.glsl"

layout(location = 2) in vec4 land_normal;
layout(location = 4) in vec3 root_colour;

void main() { show_ground(grid_place(), land_normal.xyz, root_colour); }
