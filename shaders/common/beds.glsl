// SPDX-License-Identifier: Apache-2.0
// Where in the picture of the grain the beds of stone lie: drawn out along the ground and upright on what is steep, so
// that cliffs are not streaked downward; winding, so that no whole side of a mountain lies along them.
const float kBeds = 0.2;       // tiles of them to one of the grain
const float kFarBeds = 0.35;   // of those far off to one of the near: larger, as less is seen of them
const float kBedsEnd = 12.0;   // over this part of the way to where they end, the near lessen, and the far grow beyond
const float kBedded = 1.0;     // their strength, of the grain's
const float kFarBedded = 0.5;  // likewise, far off

vec2 beds_at(vec3 at_m) {
    vec2 winding = 26.0 * sin(at_m.xz * vec2(0.029, 0.036));
    return vec2(at_m.x + at_m.z + winding.x + winding.y, 1.4 * at_m.y + 0.25 * (at_m.x - at_m.z)) *
           (kBeds * view.scales.y);
}
