#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The sun's disc, added to the sky where clouds and air let it through.
#include "common/view.glsl"
#include "common/clouds.glsl"

in vec3 ray;
in vec2 from_middle;
layout(location = 0) out vec4 pixel;

void main() {
    float disc = clamp((1.0 - dot(from_middle, from_middle)) * 4.0, 0.0, 1.0);
    float clear = clamp(ray.y * 9.0 + 0.25, 0.0, 1.0) * (1.0 - clouds_along(ray).x);
    pixel = vec4(view.sun_colour.rgb * (disc * clear), 0.0);
}
