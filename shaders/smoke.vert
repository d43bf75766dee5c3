#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Smoke from chimneys: puffs that rise, widen, and go with the wind, each as old as its place in the row and the time
// say.
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"

layout(location = 0) in vec3 chimney_m;
layout(location = 1) in vec4 corner_age;  // xy: -1 to 1; z: age at the beginning, w: chance, both 0 to 1
layout(location = 2) in vec3 plume;       // x: how dense, y: how wide, z: how high, 1 each as usual
layout(location = 0) uniform vec4 wind_scale;  // xy: m/s east and south; z: opacity
layout(location = 1) uniform vec4 reach;       // xy: about, m; z: split, m; w: 1 what is near, -1 what is far, 0 all

out vec2 on_puff;
out vec4 puff;

const float kLife_s = 11.0;

void main() {
    float age = fract(view.eye_seconds.w / kLife_s + corner_age.z);
    float rise_m = 10.0 * plume.z * (1.0 - exp2(-2.2 * age)) / (1.0 + 0.25 * dot(wind_scale.xy, wind_scale.xy));
    vec2 drift_m = wind_scale.xy * kLife_s * age * (0.25 + 0.75 * age);
    vec3 at_m = chimney_m + vec3(drift_m.x, rise_m, drift_m.y);
    float turn = corner_age.w * 6.2831853 + 2.0 * age;
    at_m.xz += (0.25 + 0.4 * plume.y) * age * vec2(sin(turn * 3.0), cos(turn * 2.0));
    vec3 ray = at_m - view.eye_seconds.xyz;
    vec3 right = normalize(cross(ray, vec3(0.0, 1.0, 0.0)));
    vec3 up = normalize(cross(right, ray));
    float wide_m = 0.16 + 0.06 * plume.y + 1.7 * plume.y * age * (0.7 + 0.6 * corner_age.w);
    gl_Position = view.clip_from_world * vec4(at_m + wide_m * (corner_age.x * right + corner_age.y * up), 1.0);
    bool is_near = distance(chimney_m.xz, reach.xy) < reach.z;
    if (reach.w != 0.0 && is_near != (reach.w > 0.0)) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    vec4 haze = haze_at(at_m);
    vec3 light = 0.62 * ambient_on(vec3(0.0, 1.0, 0.0)) + 0.34 * view.sunlight.rgb;
    float dense = min(age * 14.0, 1.0) * (1.0 - age) * (1.0 - age) * plume.x * (0.55 + 0.9 * corner_age.w);
    puff = vec4(mix(encode(light), haze.rgb, haze.a), wind_scale.z * dense);
    on_puff = corner_age.xy;
}
