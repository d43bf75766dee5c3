#version 310 es
// SPDX-License-Identifier: Apache-2.0
precision highp float;
layout(binding = 0) uniform sampler2D other;

in vec2 over_other;
layout(location = 0) out vec4 pixel;

void main() { pixel = texture(other, over_other); }
