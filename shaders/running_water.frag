#version 310 es
// SPDX-License-Identifier: Apache-2.0
// As water.frag, with ripples that go with the current: two pictures of them, each carried off and let go in turn,
// shown while they are whole.
#include "common/view.glsl"

layout(binding = 0) uniform sampler2D ground;   // a: how deep the water over it looks, 0 to 1
layout(binding = 1) uniform sampler2D ripples;  // r: slope, 0.5 is level

in vec2 over_land;
in vec4 before;
in float glitter;
in float white;
in vec4 carried;     // xy, zw: where in the ripples, of both pictures
flat in float turn;  // how much of the second is shown
layout(location = 0) out vec4 pixel;

void main() {
    float slope = mix(texture(ripples, carried.xy).r, texture(ripples, carried.zw).r, turn) * 2.4 - 1.2;
    float deep = texture(ground, over_land).a;
    vec3 body = view.shallow_water.rgb + view.deepening.rgb * deep;
    float bright = 1.0 + 0.20 * slope + exp2(glitter + slope * 17.0);
    float foam = max(white - deep * 13.0, 0.0) * view.mirrored.w;
    pixel = vec4((before.rgb + body * before.a) * bright + foam, deep * 4.5 + (0.3 + foam));
}
