#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Ground so near that its grain is seen.
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/cloud_shadow.glsl"
#include "common/land.glsl"

layout(location = 3) in vec2 kinds;
layout(location = 1) uniform float farthest;  // 1/m: beyond there is no grain

out vec2 over_grain;
out vec2 over_beds;
out vec3 grains;  // how much shows of each kind's grain, and of stone's beds

const float kBeds = 0.2;    // tiles of them to one of the grain
const float kBedded = 1.2;  // their strength, of the grain's

void main() {
    vec3 at_m = show_land();
    over_grain = at_m.xz * view.scales.y;
    // Drawn out along the ground and upright on what is steep, so that cliffs are not streaked downward; winding, so
    // that no whole side of a mountain lies along the beds.
    vec2 winding = 26.0 * sin(at_m.xz * vec2(0.029, 0.036));
    over_beds = vec2(at_m.x + at_m.z + winding.x + winding.y, 1.4 * at_m.y + 0.25 * (at_m.x - at_m.z)) *
                (kBeds * view.scales.y);
    float left = 1.0 - distance(at_m, view.eye_seconds.xyz) * farthest;
    grains = kinds.xyy * vec3(1.0, 0.5, kBedded) * (view.scales.z * clear * clamp(3.0 * left, 0.0, 1.0));
}
