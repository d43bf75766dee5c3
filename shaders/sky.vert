#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/haze.glsl"

layout(location = 0) in vec3 direction;    // unit
layout(location = 1) in vec4 dome_colour;  // shown

out vec3 ray;
out vec4 behind;  // rgb: shown, the dome and the air before it; a: how clear the air is for clouds

void main() {
    vec4 clip = view.clip_from_world * vec4(view.eye_seconds.xyz + direction * 1000.0, 1.0);
    gl_Position = clip.xyww;  // at the far end: behind all else, and hidden by it before it is shaded
    ray = direction;
    float up = max(direction.y, 0.0);
    vec3 air = haze_towards(dot(direction, view.to_sun.xyz));
    behind = vec4(mix(dome_colour.rgb * view.to_sun.w, air, exp2(-up * 26.0)), clamp(direction.y * 14.0, 0.0, 1.0));
}
