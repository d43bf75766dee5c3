#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Ground so near that its grain is seen.
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/cloud_shadow.glsl"
#include "common/land.glsl"
#include "common/beds.glsl"

layout(location = 3) in vec2 kinds;
layout(location = 1) uniform float farthest;  // 1/m: beyond there is no grain

out vec2 over_grain;
out vec2 over_beds;
out vec3 grains;  // how much shows of each kind's grain, and of stone's beds

void main() {
    vec3 at_m = show_land();
    over_grain = at_m.xz * view.scales.y;
    over_beds = beds_at(at_m);
    float left = 1.0 - distance(at_m, view.eye_seconds.xyz) * farthest;
    // Where beds end larger ones begin (ground.vert).
    vec3 kind = kinds.xyy * vec3(1.0, 0.5, kBedded) * clamp(left * vec3(3.0, 3.0, kBedsEnd), 0.0, 1.0);
    grains = kind * (view.scales.z * clear);
}
