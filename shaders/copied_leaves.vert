#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Near leaves once more: each blade stands for some that are smaller.
#include "common/view.glsl"
#include "common/night_eye.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/instance.glsl"
#include "common/leaf_light.glsl"
#include "common/leaf.glsl"

layout(location = 1) uniform vec4 turns_aside_m;  // xyz: 1/m, another for each copy: how soon blades fan out otherwise;
                                                 // w: how far a copy's tip may lie from its blade's, on each axis

// About the blade's own foot, each blade's another way.
vec3 fanned(vec3 from_site_m) {
    float aside_m = min(turns_aside_m.w, dot(abs(from_site_m), vec3(0.6)));
    return from_site_m + fract(site_m * turns_aside_m.xyz) * (2.0 * aside_m) - aside_m;
}
