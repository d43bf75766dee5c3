#version 310 es
// SPDX-License-Identifier: Apache-2.0
// A picture's next coarser level: between four pixels of the finer one.
precision highp float;
layout(binding = 0) uniform sampler2D picture;
layout(location = 1) uniform float finer;  // level

in vec2 over_other;
layout(location = 0) out vec4 pixel;

void main() { pixel = textureLod(picture, over_other, finer); }
