#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/cloud_tiles.glsl"

layout(location = 0) in vec2 corner;  // of a square about the disc, -1 to 1

out vec4 tiles;
out float up;
out vec3 on_disc;  // times w

void main() {
    vec3 across = normalize(vec3(-view.to_sun.z, 1e-4, view.to_sun.x));
    vec3 upward = cross(view.to_sun.xyz, across) * -1.0;
    vec3 ray = view.to_sun.xyz + (across * corner.x + upward * corner.y) * view.disc.w;
    vec3 on_layers = on_clouds(ray);
    vec4 clip = view.clip_from_world * vec4(view.eye_seconds.xyz + on_layers * 100.0, 1.0);
    gl_Position = clip.xyww;
    // So near to each other its corners have one bearing's seam.
    float bearing = atan(view.to_sun.x, -view.to_sun.z) + corner.x * view.disc.w / max(length(view.to_sun.xz), 0.1);
    tiles = cloud_tiles(ray, bearing, on_layers);
    up = ray.y;
    // Its corners lie on the clouds, at unlike distances: the picture must not be drawn out along them.
    on_disc = clip.w * vec3(vec2(0.5, -0.5) * corner + 0.5, 1.0);
}
