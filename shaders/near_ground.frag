#version 310 es
// SPDX-License-Identifier: Apache-2.0
// ground.frag, with the grain of what is near.
precision highp float;

layout(binding = 0) uniform sampler2D ground;  // rgb: shown
layout(binding = 1) uniform sampler2D grain;   // of soft ground and of stone; 0.5 is level

in vec2 over_land;
in vec2 over_grain;
in vec2 over_beds;
in vec3 grains;
in vec3 veil;
in float clear;
layout(location = 0) out vec4 pixel;

void main() {
    // At two sizes: tufts, and at one's feet what lies between them.
    vec2 both = texture(grain, over_grain).rg + texture(grain, over_grain.yx * 4.7).rg;
    float beds = texture(grain, over_beds).g;
    float rough = clear + dot(vec3(both, beds) - vec3(1.0, 1.0, 0.5), grains);
    pixel = vec4(texture(ground, over_land, -0.8).rgb * rough + veil, 1.0);
}
