#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Stone lit, hazed and encoded a vertex, with what lichen covers of it.
precision highp float;
layout(binding = 0) uniform sampler2D crusts;  // how far a pale one covers the stone, and an orange one
layout(binding = 1) uniform sampler2D grain;   // g: of stone; 0.5 is level
in vec3 shown;
in vec3 to_pale;  // what each adds where it covers all
in vec3 to_orange;
in vec2 over_stone;
in vec2 over_beds;
in vec3 bedded;
layout(location = 0) out vec4 pixel;

void main() {
    vec2 covered = texture(crusts, over_stone).rg;
    float rough = texture(grain, over_beds).g - 0.5;
    pixel = vec4(shown + rough * bedded + covered.r * to_pale + covered.g * to_orange, 1.0);
}
