#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Wood, leaves and surround: lit, hazed and encoded a vertex, so that a pixel costs next to nothing.
precision highp float;
in vec3 shown;
layout(location = 0) out vec4 pixel;

void main() { pixel = vec4(shown, 1.0); }
