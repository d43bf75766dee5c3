#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/clouds.glsl"

in vec4 tiles;
in vec4 behind;
in float glow;
layout(location = 0) out vec4 pixel;

void main() {
    vec2 clouds = clouds_at(tiles) * behind.a;
    float opacity = clouds.x;
    // Thin cloud before the sun shines: its silver lining.
    float light = clouds.y + glow * (opacity - opacity * opacity);
    vec3 shown = behind.rgb + (view.cloud_shaded.rgb - behind.rgb) * opacity + view.cloud_gain.rgb * light;
    // Half a step of noise against banding.
    pixel = vec4(shown + fract(tiles.x * 7919.0) * (1.0 / 255.0), 1.0);
}
