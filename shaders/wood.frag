#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Bark: lit at the corners; its relief tilts that light and its furrows darken it, for the price of one fetch.
precision highp float;
layout(binding = 0) uniform sampler2D bark_picture;  // rg: slope across and along, 1/2 level; b: lightness, 1/2 its own
in vec3 shown;
in vec3 veil;
in vec2 on_bark;
in vec2 slant;
layout(location = 0) out vec4 pixel;

void main() {
    vec3 bark = texture(bark_picture, on_bark).rgb * 2.0 - 1.0039;
    // What rises shines little; furrows are what is seen of bark.
    float relief = clamp(1.0 + dot(bark.rg, slant) + bark.b, 0.25, 1.2);
    pixel = vec4(shown * relief + veil, 1.0);
}
