#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/haze.glsl"

layout(location = 0) in vec3 direction;    // unit
layout(location = 1) in vec4 dome_colour;  // shown

out vec3 ray;
out vec4 behind;  // rgb: shown, the dome, the sun's glow and the air before them; a: how clear the air is for clouds
out float glow;

void main() {
    vec4 clip = view.clip_from_world * vec4(view.eye_seconds.xyz + direction * 1000.0, 1.0);
    gl_Position = clip.xyww;  // at the far end: behind all else, and hidden by it before it is shaded
    ray = direction;
    float up = max(direction.y, 0.0);
    float cos_to_sun = dot(direction, view.to_sun.xyz);
    glow = exp2(cos_to_sun * 22.0 - 22.0);
    vec3 shown = dome_colour.rgb * view.to_sun.w + view.sun_colour.rgb * (0.25 * glow * glow);
    behind = vec4(mix(shown, haze_towards(cos_to_sun), exp2(-up * 26.0)), clamp(direction.y * 14.0, 0.0, 1.0));
}
