#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/haze.glsl"

layout(location = 0) in vec2 column_row;
layout(location = 1) in float height_m;
layout(location = 3) in vec2 kinds;
layout(location = 0) uniform vec2 grid;  // x: cell, m; y: column of the middle

out vec2 over_land;  // 0 to 1 over the land's square
out vec2 over_grain;
out vec2 grains;  // how much of each kind's grain shows
out vec4 haze;

void main() {
    vec2 xz = (column_row - grid.y) * grid.x;
    vec3 at_m = vec3(xz.x, height_m, xz.y);
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    over_land = xz * view.light_above.w + 0.5;
    over_grain = xz * view.light_around.w;
    grains = kinds * view.light_below.w;
    haze = haze_at(at_m);
}
