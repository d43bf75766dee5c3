#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"

layout(binding = 0) uniform sampler2D ground;   // a: how deep the water over it looks, 0 to 1
layout(binding = 1) uniform sampler2D ripples;  // r: slope toward the north-west; g: a quarter turn later; 0.5 is level

in vec2 over_land;
in vec4 before;
in float glitter;
in float white;
layout(location = 0) out vec4 pixel;

void main() {
    vec2 turns = texture(ripples, over_land * 11.0).rg;
    float slope = turns.r * view.shallow_water.w + turns.g * view.deepening.w - view.scales.w;
    float deep = texture(ground, over_land).a;
    vec3 body = view.shallow_water.rgb + view.deepening.rgb * deep;
    // A ripple that leans away shows a higher, darker piece of sky; one that leans just so, the sun.
    float bright = 1.0 + 0.20 * slope + exp2(glitter + slope * 17.0);
    float foam = max(white - deep * 13.0, 0.0) * view.mirrored.w;
    // The shore shows through. The target clamps.
    pixel = vec4((before.rgb + body * before.a) * bright + foam, deep * 4.5 + (0.3 + foam));
}
