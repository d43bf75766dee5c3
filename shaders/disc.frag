#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The sun's disc or the moon's, added to the sky where clouds and air let it through.
#include "common/view.glsl"
#include "common/clouds.glsl"

layout(binding = 2) uniform sampler2D disc;  // r: light
in vec4 tiles;
in float up;
in vec3 on_disc;
layout(location = 0) out vec4 pixel;

void main() {
    float clear = clamp(up * 9.0 + 0.25, 0.0, 1.0) * (1.0 - clouds_at(tiles).x);
    pixel = vec4(view.disc.rgb * (textureProj(disc, on_disc).r * clear), 0.0);
}
