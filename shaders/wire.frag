#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The edges of triangles, for whoever develops.
precision highp float;
layout(location = 15) uniform vec3 colour;  // of the level
layout(location = 0) out vec4 pixel;

void main() { pixel = vec4(colour, 1.0); }
