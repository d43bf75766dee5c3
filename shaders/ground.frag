#version 310 es
// SPDX-License-Identifier: Apache-2.0
// What the ground is made of, its coarse relief and the light on it lie multiplied in one picture, encoded for the
// display already: air and the clouds' shadow scale it, which is nearly what they would do to the light.
precision highp float;

layout(binding = 0) uniform sampler2D ground;  // rgb: shown

in vec2 over_land;
in vec3 veil;
in float clear;
layout(location = 0) out vec4 pixel;

void main() {
    pixel = vec4(texture(ground, over_land, -0.8).rgb * clear + veil, 1.0);
}
