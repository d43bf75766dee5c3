#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Stone lit, hazed and encoded a vertex, with what lichen covers of it.
precision highp float;
layout(binding = 0) uniform sampler2D crusts;  // how far a pale one covers the stone, and an orange one
in vec3 shown;
in vec3 to_pale;  // what each adds where it covers all
in vec3 to_orange;
in vec2 over_stone;
layout(location = 0) out vec4 pixel;

void main() {
    vec2 covered = texture(crusts, over_stone).rg;
    pixel = vec4(shown + covered.r * to_pale + covered.g * to_orange, 1.0);
}
