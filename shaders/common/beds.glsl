// SPDX-License-Identifier: Apache-2.0
// Where in the picture of the grain the beds of stone lie: drawn out along the ground and upright on what is steep, so
// that cliffs are not streaked downward; winding, so that no whole side of a mountain lies along them.
const float kBeds = 0.2;    // tiles of them to one of the grain
const float kBedded = 1.2;  // their strength, of the grain's

vec2 beds_at(vec3 at_m) {
    vec2 winding = 26.0 * sin(at_m.xz * vec2(0.029, 0.036));
    return vec2(at_m.x + at_m.z + winding.x + winding.y, 1.4 * at_m.y + 0.25 * (at_m.x - at_m.z)) *
           (kBeds * view.scales.y);
}
