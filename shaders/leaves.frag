#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Near leaves: lit at the corners; their veins lighten or darken that, for the price of one fetch. So do the many leaves
// that a mass of a crown stands for, or a blade that is much enlarged.
precision highp float;
layout(binding = 0) uniform sampler2D leaf_picture;  // r: lightness, 1/2 the blade's own
in vec3 shown;
in vec3 on_blade;  // z: how far its picture shows
layout(location = 0) out vec4 pixel;

void main() { pixel = vec4(shown * ((texture(leaf_picture, on_blade.xy).r - 0.502) * on_blade.z + 1.0), 1.0); }
