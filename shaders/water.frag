#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"

layout(binding = 0) uniform sampler2D ground;   // a: how deep the water over it looks, 0 to 1
layout(binding = 1) uniform sampler2D ripples;  // slopes and what they are a quarter turn later, 0.5 is level

in vec2 over_land;
in vec2 ripples_at;
in vec4 before;
in vec2 glitter;
layout(location = 0) out vec4 pixel;

void main() {
    vec4 both = texture(ripples, ripples_at) - 0.5;
    vec2 slope = both.rg * view.shallow_water.w + both.ba * view.deepening.w;
    float deep = texture(ground, over_land).a;
    vec3 body = view.shallow_water.rgb + view.deepening.rgb * deep;
    // A ripple that leans away shows a higher, darker piece of sky.
    vec3 shown = (before.rgb + body * before.a) * (1.0 + 0.30 * (slope.x + slope.y));
    float sparkle = exp2((glitter.x + dot(slope, view.to_sun.xz) * 0.4 - 1.03) * 90.0) * glitter.y;
    float foam = clamp(0.85 - deep * 7.0 + slope.x, 0.0, 1.0) * view.mirrored.w * glitter.y;
    // The shore shows through.
    pixel = vec4(shown + view.sun_colour.rgb * sparkle + foam, clamp(deep * 4.5 + 0.3, 0.0, 1.0));
}
