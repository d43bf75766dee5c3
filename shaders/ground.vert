#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/cloud_shadow.glsl"
#include "common/land.glsl"
#include "common/beds.glsl"

layout(location = 3) in vec2 kinds;
layout(location = 1) uniform float nearest;  // 1/m: nearer there is grain, which has beds of its own

out vec2 over_beds;
out float beds;  // how much of them shows

void main() {
    vec3 at_m = show_land();
    over_beds = kFarBeds * beds_at(at_m);
    float beyond = distance(at_m, view.eye_seconds.xyz) * nearest - 1.0;
    beds = kinds.y * kFarBedded * view.scales.z * clear * clamp(kBedsEnd * beyond, 0.0, 1.0);
}
