#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"

layout(location = 0) in vec2 column_row;
layout(location = 1) in float height_m;
layout(location = 2) in vec4 land_normal;
layout(location = 0) uniform vec2 grid;  // x: cell, m; y: column of the middle

out vec3 shown;

void main() {
    vec2 xz = (column_row - grid.y) * grid.x;
    vec3 at_m = vec3(xz.x, height_m, xz.y);
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);

    vec3 normal = land_normal.xyz;
    // Steep ground shows its rock.
    float flat_ground = clamp((normal.y - 0.72) * 4.3, 0.0, 1.0);
    vec3 colour = view.far_colour.rgb * mix(vec3(0.80, 0.74, 0.76), vec3(1.0), flat_ground);
    vec3 light = view.sunlight.rgb * max(dot(normal, view.to_sun.xyz), 0.0) + ambient_on(normal);
    vec4 haze = haze_at(at_m);
    shown = mix(encode(colour * light), haze.rgb, haze.a);
}
