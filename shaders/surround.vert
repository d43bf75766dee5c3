#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The country around the land, to the horizon.
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/cloud_shadow.glsl"
#include "common/lit_ground.glsl"

layout(location = 0) in vec2 column_row;
layout(location = 1) in float height_m;
layout(location = 2) in vec4 land_normal;
layout(location = 4) in vec3 root_colour;
layout(location = 0) uniform vec2 grid;  // x: cell, m; y: column of the middle

void main() {
    vec2 xz = (column_row - grid.y) * grid.x;
    show_ground(vec3(xz.x, height_m, xz.y), land_normal.xyz, root_colour);
}
