#version 310 es
// SPDX-License-Identifier: Apache-2.0
// A rainbow: rings about the point opposite the sun.
#include "common/view.glsl"

layout(location = 0) in vec4 around;  // xy: cosine and sine of the place on the ring; zw: of the ring's radius
layout(location = 1) in vec3 colour;

out vec3 shown;

void main() {
    vec3 across = normalize(vec3(-view.to_sun.z, 1e-4, view.to_sun.x));
    vec3 upward = cross(across, view.to_sun.xyz);
    vec3 direction = -view.to_sun.xyz * around.z + (across * around.x + upward * around.y) * around.w;
    vec4 clip = view.clip_from_world * vec4(view.eye_seconds.xyz + direction * 1000.0, 1.0);
    gl_Position = clip.xyww;
    shown = colour * (view.glare.w * clamp(direction.y * 6.0 + 0.55, 0.0, 1.0));
}
