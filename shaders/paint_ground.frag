#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The ground's picture, painted once for a sun that stands still: what it is made of, in the light baked for it.
precision highp float;

#include "common/encode.glsl"

layout(binding = 0) uniform sampler2D roots;  // rgb: of its colour's linear light
layout(binding = 1) uniform sampler2D kinds;  // how far its grain is soft ground's, how far stone's
layout(binding = 2) uniform sampler2D light;  // rgb: linear, halved; a: depth of water over the ground, 1 is 24 m
layout(binding = 3) uniform sampler2D grain;  // lit; 0.5 is level
layout(location = 1) uniform vec2 relief_rim;  // how strong the relief is; how far from the middle the rim begins

in vec4 over_land_and_kinds;
in vec4 over_relief_and_middle;
layout(location = 0) out vec4 pixel;

void main() {
    vec4 lit = texture(light, over_land_and_kinds.xy);
    vec3 shown = encode_root(texture(roots, over_land_and_kinds.xy).rgb * sqrt(2.0 * lit.rgb));
    vec2 rough = textureLod(grain, over_relief_and_middle.xy, 1.0).rg - 0.5;
    shown += shown * (relief_rim.x * dot(rough, texture(kinds, over_land_and_kinds.zw).rg));
    // What light is lost on the way down and up. The rim is deep: all beyond it repeats the rim.
    vec2 off = abs(over_relief_and_middle.zw);
    pixel = vec4(shown, max(off.x, off.y) > relief_rim.y ? 1.0 : 1.0 - exp2(-0.35 * 24.0 * 1.442695 * lit.a));
}
