#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/whole_picture.glsl"

layout(location = 0) uniform float relief_tiles;  // of the coarse relief, to a side of the land
layout(location = 2) uniform vec2 kinds_px;       // size of that picture, a pixel a sample

out vec4 over_land_and_kinds;
out vec2 over_relief;

void main() {
    vec2 over_land = corner_of_whole();
    over_land_and_kinds = vec4(over_land, (over_land * (kinds_px - 1.0) + 0.5) / kinds_px);
    vec2 east_south = (over_land - 0.5) * relief_tiles;
    over_relief = east_south + 0.5 * vec2(-east_south.y, east_south.x);
    gl_Position = vec4(2.0 * over_land - 1.0, 0.0, 1.0);
}
