#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The sun's disc, which is added to the sky, or the moon's, which hides it, where clouds and air let them through.
#include "common/view.glsl"
#include "common/clouds.glsl"

layout(binding = 2) uniform sampler2D disc;  // r: light; g: how much of the sky it hides
in vec4 tiles;
in float up;
in vec3 on_disc;
layout(location = 0) out vec4 pixel;

void main() {
    float clear = clamp(up * 9.0 + 0.25, 0.0, 1.0) * (1.0 - clouds_at(tiles).x);
    vec2 seen = textureProj(disc, on_disc).rg * clear;
    pixel = vec4(view.disc.rgb * seen.r, seen.g);
}
