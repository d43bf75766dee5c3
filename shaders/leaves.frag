#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Near leaves: lit at the corners; their veins lighten or darken that, for the price of one fetch.
precision highp float;
layout(binding = 0) uniform sampler2D leaf_picture;  // r: lightness, 1/2 the blade's own
in vec3 shown;
in vec2 on_blade;
layout(location = 0) out vec4 pixel;

void main() { pixel = vec4(shown * (texture(leaf_picture, on_blade).r + 0.498), 1.0); }
