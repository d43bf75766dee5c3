#version 310 es
// SPDX-License-Identifier: Apache-2.0
// What the ground is made of and the light on it lie multiplied in one picture, as its square root: the encoding is a
// polynomial in that root, so no root is taken here.
#include "common/view.glsl"
#include "common/encode.glsl"

layout(binding = 0) uniform sampler2D ground;  // rgb: root of half the light it sends
layout(binding = 1) uniform sampler2D grain;

in vec2 over_land;
in vec2 over_grain;
in vec4 haze;
layout(location = 0) out vec4 pixel;

void main() {
    float rough = texture(grain, over_grain).r * view.light_below.w + view.sunlight.w;
    vec3 shown = encode_root(texture(ground, over_land).rgb * rough);
    pixel = vec4(mix(shown, haze.rgb, haze.a), 1.0);
}
