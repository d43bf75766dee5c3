#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/cloud_tiles.glsl"

layout(location = 0) in vec4 direction_bearing;  // xyz: unit; w: bearing, rad, -pi to pi on the ring's two ends
layout(location = 1) in vec4 dome_colour;  // shown

out vec4 tiles;
out vec4 behind;  // rgb: shown, the dome, the sun's glow and the air before them; a: how clear the air is for clouds
out float glow;

// How much mist lies above the eye toward this height.
float mist_above(float rise) {
    float below_m = max(view.mist.y - view.eye_seconds.y, 0.0);
    float eye = max(view.eye_seconds.y - view.mist.y, 0.0) * view.mist.z;
    float column = view.mist.x * (below_m + exp2(-eye) * 1.442695 / view.mist.z);
    return 1.0 - exp2(-column / max(rise, 0.015));
}

void main() {
    vec3 direction = direction_bearing.xyz;
    vec3 on_layers = on_clouds(direction);
    vec4 clip = view.clip_from_world * vec4(view.eye_seconds.xyz + on_layers * 100.0, 1.0);
    gl_Position = clip.xyww;  // at the far end: behind all else, and hidden by it before it is shaded
    tiles = cloud_tiles(direction, direction_bearing.w, on_layers);
    float rise = max(direction.y, 0.0);
    float cos_to_glow = dot(direction, view.to_glow.xyz);
    glow = exp2(cos_to_glow * 22.0 - 22.0);
    float near_disc = exp2(dot(direction, view.to_sun.xyz) * 22.0 - 22.0);
    vec3 shown = dome_colour.rgb * view.to_sun.w;
    shown += view.glare.rgb * (near_disc * near_disc) * (1.0 - 0.85 * shown);
    float mist = mist_above(rise);
    float air = max(exp2(-rise * view.mist.w), mist);
    behind = vec4(mix(shown, haze_towards(cos_to_glow), air), (1.0 - exp2(-22.0 * rise)) * (1.0 - mist));
    glow *= view.to_glow.w;
}
