#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Lit, hazed and encoded a vertex, with woods, clearings and gullies from the grain of what is near, many times as large:
// at two sizes, so that no tile is seen again in the next.
precision highp float;

layout(binding = 1) uniform sampler2D grain;  // of soft ground and of stone; 0.5 is level

in vec3 bare;
in vec3 veil;
in vec4 over_grain;  // xy: the smaller, zw: the larger
in vec2 grains;      // how much of each kind's grain shows
layout(location = 0) out vec4 pixel;

void main() {
    vec2 both = texture(grain, over_grain.xy).rg + texture(grain, over_grain.zw).rg - 1.0;
    pixel = vec4(bare * (1.0 + dot(both, grains)) + veil, 1.0);
}
