#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/haze.glsl"

layout(location = 0) in vec2 around_m;  // rings about the eye, wider and wider, so that air can be worked out a vertex

out vec2 over_land;
out vec2 ripples_at;
out vec3 ray;
out vec4 haze;

void main() {
    vec2 xz = view.eye_seconds.xz + around_m;
    vec3 at_m = vec3(xz.x, 0.0, xz.y);
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    over_land = xz * view.light_above.w + 0.5;
    ripples_at = xz * (1.0 / 34.0);
    ray = at_m - view.eye_seconds.xyz;
    haze = haze_at(at_m);
}
