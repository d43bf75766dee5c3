#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The sea: rings about the eye, wider and wider.
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/water_surface.glsl"
#include "common/carried.glsl"

layout(location = 0) in vec2 around_m;

void main() {
    vec2 xz = view.eye_seconds.xz + around_m;
    show_water(vec3(xz.x, 0.0, xz.y), 0.33);
    carry(xz, vec2(0.7, 0.4));  // with the wind
}
