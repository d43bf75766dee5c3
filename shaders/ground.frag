#version 310 es
// SPDX-License-Identifier: Apache-2.0
// What the ground is made of and the light on it lie multiplied in one picture, as its square root: the encoding is a
// polynomial in that root, so no root is taken here.
#include "common/view.glsl"
#include "common/encode.glsl"

layout(binding = 0) uniform sampler2D ground;  // rgb: root of half the light it sends
layout(binding = 1) uniform sampler2D grain;    // of soft ground and of stone; 0.5 is level

in vec2 over_land;
in vec2 over_grain;
in vec2 grains;
in vec4 haze;
layout(location = 0) out vec4 pixel;

void main() {
    // Near and farther off: the same relief twice, its lattices turned against each other.
    vec2 near = texture(grain, over_grain).rg;
    vec2 far = texture(grain, vec2(over_grain.x - 0.5 * over_grain.y, 0.5 * over_grain.x + over_grain.y) * 0.107).rg;
    float rough = dot(near + far - 1.0, grains) + view.sunlight.w;
    vec3 shown = encode_root(texture(ground, over_land).rgb * rough);
    pixel = vec4(mix(shown, haze.rgb, haze.a), 1.0);
}
