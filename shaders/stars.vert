#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/cloud_tiles.glsl"

layout(location = 0) in vec4 direction_light;  // xyz: unit; w: 0 to 1
layout(location = 0) uniform float px;         // a screen's pixel of 1080 lines, in pixels of this view

out vec4 tiles;
out float light;

void main() {
    vec3 direction = direction_light.xyz;
    vec4 clip = view.clip_from_world * vec4(view.eye_seconds.xyz + direction * 1000.0, 1.0);
    gl_Position = clip.xyww;
    tiles = cloud_tiles(direction, atan(direction.x, -direction.z), on_clouds(direction));
    float size = (2.2 + 5.0 * direction_light.w) * px;
    // A star smaller than a pixel is a dimmer pixel.
    gl_PointSize = max(size, 1.5);
    float spread = min(size / 1.5, 1.0);
    float twinkle = 0.88 + 0.12 * sin(view.eye_seconds.w * 3.1 + dot(direction, vec3(311.0, 173.0, 257.0)));
    light = (0.5 + 0.5 * direction_light.w) * spread * twinkle * clamp(direction.y * 7.0, 0.0, 1.0) * view.to_sun.w;
}
