#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"

layout(location = 0) in vec3 direction;  // unit; the dome's vertices stand dense enough to take it as unit between them
layout(location = 1) in vec4 dome_colour;  // root of it

out vec3 ray;
out vec3 root;

void main() {
    vec4 clip = view.clip_from_world * vec4(view.eye_seconds.xyz + direction * 1000.0, 1.0);
    gl_Position = clip.xyww;  // at the far end: behind all else, and hidden by it before it is shaded
    ray = direction;
    root = dome_colour.rgb;
}
