#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Surround and stone: lit and hazed a vertex; clouds pass over them.
#include "common/view.glsl"
#include "common/cloud_light.glsl"

in vec3 shown;
in vec3 veil;
in vec2 over_clouds;
layout(location = 0) out vec4 pixel;

void main() { pixel = vec4(shown * cloud_light(over_clouds) + veil, 1.0); }
