#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The ground's picture, painted once for a sun that stands still: what it is made of, in the light baked for it.
precision highp float;

#include "common/encode.glsl"

layout(binding = 0) uniform sampler2D roots;  // rgb: of its colour's linear light
layout(binding = 1) uniform sampler2D kinds;  // how far its grain is soft ground's, how far stone's; a pixel a sample
layout(binding = 2) uniform sampler2D light;  // rgb: linear, halved; a: depth of water over the ground, 1 is 24 m
layout(binding = 3) uniform sampler2D grain;  // lit; 0.5 is level
layout(location = 0) uniform float relief_tiles;  // of the coarse relief, to a side of the land
layout(location = 1) uniform float relief;        // how strong it is

in vec2 over_land;
layout(location = 0) out vec4 pixel;

void main() {
    vec4 lit = texture(light, over_land);
    vec3 shown = encode_root(texture(roots, over_land).rgb * sqrt(2.0 * lit.rgb));
    vec2 samples = vec2(textureSize(kinds, 0));
    vec2 kind = texture(kinds, (over_land * (samples - 1.0) + 0.5) / samples).rg;
    vec2 east_south = (over_land - 0.5) * relief_tiles;
    vec2 rough = textureLod(grain, east_south + 0.5 * vec2(-east_south.y, east_south.x), 1.0).rg - 0.5;
    shown *= 1.0 + relief * dot(rough, kind);
    // What light is lost on the way down and up. The rim is deep: all beyond it repeats the rim.
    float deep = 1.0 - exp(-0.35 * 24.0 * lit.a);
    vec2 from_rim = min(over_land, 1.0 - over_land) * vec2(textureSize(roots, 0));
    if (min(from_rim.x, from_rim.y) < 1.0) deep = 1.0;
    pixel = vec4(shown, deep);
}
