#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Boulders, arches, caves.
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/cloud_shadow.glsl"
#include "common/lit_ground.glsl"

layout(location = 0) in vec3 at_m;
layout(location = 2) in vec4 facet_normal;
layout(location = 4) in vec3 root_colour;

void main() { show_ground(at_m, facet_normal.xyz, root_colour); }
