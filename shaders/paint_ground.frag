#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The ground's picture, painted once for a sun that stands still: what it is made of, in the light baked for it.
precision highp float;

#include "common/encode.glsl"

// A pixel of it for each that is painted. rgb: of its colour's linear light; a: 1 where water hides the ground anyway.
layout(binding = 0) uniform sampler2D roots;
layout(binding = 1) uniform sampler2D kinds;  // how far its grain is soft ground's, how far stone's
layout(binding = 2) uniform sampler2D light;  // rgb: linear, halved; a: depth of water over the ground, 1 is 24 m
layout(binding = 3) uniform sampler2D grain;  // lit; 0.5 is level
layout(location = 1) uniform float relief;  // how strong it is
layout(location = 3) uniform int first_row;  // of the band

in vec4 over_land_and_kinds;
in vec2 over_relief;
layout(location = 0) out vec4 pixel;

void main() {
    vec4 lit = texture(light, over_land_and_kinds.xy);
    vec4 root = texelFetch(roots, ivec2(gl_FragCoord.xy) - ivec2(0, first_row), 0);
    vec3 shown = encode_root(sqrt(2.0 * lit.rgb) * root.rgb);
    vec2 rough = textureLod(grain, over_relief, 1.0).rg;
    shown *= 1.0 + dot(rough - 0.5, relief * texture(kinds, over_land_and_kinds.zw).rg);
    // What light is lost on the way down and up.
    pixel = vec4(shown, max(root.a, 1.0 - exp2(-0.35 * 24.0 * 1.442695 * lit.a)));
}
