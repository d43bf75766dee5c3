#version 310 es
// SPDX-License-Identifier: Apache-2.0
// What the ground is made of, its coarse relief and the light on it lie multiplied in one picture, encoded for the
// display already: air and the clouds' shadow scale it, which is nearly what they would do to the light. Seen from above,
// it has little to show of a cliff, which has beds.
precision highp float;

layout(binding = 0) uniform sampler2D ground;  // rgb: shown
layout(binding = 1) uniform sampler2D grain;   // g: of stone; 0.5 is level

in vec2 over_land;
in vec2 over_beds;
in float beds;
in vec3 veil;
in float clear;
layout(location = 0) out vec4 pixel;

void main() {
    float rough = clear + (texture(grain, over_beds).g - 0.5) * beds;
    pixel = vec4(texture(ground, over_land, -0.8).rgb * rough + veil, 1.0);
}
