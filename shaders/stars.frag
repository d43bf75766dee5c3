#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/clouds.glsl"

in vec4 tiles;
in float light;
layout(location = 0) out vec4 pixel;

void main() {
    vec2 from_middle = gl_PointCoord * 2.0 - 1.0;
    float round = max(1.0 - dot(from_middle, from_middle), 0.0);
    pixel = vec4(vec3(0.93, 0.96, 1.0) * (light * round * (1.0 - clouds_at(tiles).x)), 0.0);
}
