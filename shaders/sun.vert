#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"

layout(location = 0) in vec2 corner;  // of a square about the disc, in its radii

out vec3 ray;
out vec2 from_middle;

void main() {
    vec3 across = normalize(vec3(view.to_sun.z, 1e-4, -view.to_sun.x));
    vec3 up = cross(across, view.to_sun.xyz);
    ray = view.to_sun.xyz + (across * corner.x + up * corner.y) * view.sun_colour.w;
    vec4 clip = view.clip_from_world * vec4(view.eye_seconds.xyz + ray * 1000.0, 1.0);
    gl_Position = clip.xyww;
    from_middle = corner;
}
