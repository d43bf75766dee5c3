#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/encode.glsl"
#include "common/dither.glsl"

layout(binding = 0) uniform sampler2D ground;  // rgb: root of half the light it sends
layout(binding = 1) uniform sampler2D grain;

in vec2 over_land;
in vec2 over_grain;
in vec4 haze;
layout(location = 0) out vec4 pixel;

void main() {
    vec3 root = texture(ground, over_land).rgb;
    float rough = texture(grain, over_grain).r * view.light_below.w + (1.0 - 0.5 * view.light_below.w);
    vec3 lit = root * root * (rough * 2.0 * view.sunlight.w);
    pixel = vec4(encode(mix(lit, haze.rgb, haze.a)) + dither(), 1.0);
}
