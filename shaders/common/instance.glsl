// SPDX-License-Identifier: Apache-2.0
// One plant, as attributes with divisor 1: a Raspberry Pi has no storage buffers in vertex shaders. What is the same for
// a whole plant (air, wind, the light through its leaves) is worked out once for it, on the CPU.
layout(location = 8) in vec4 root_scale;         // xyz: root, m; w: of the species' size
layout(location = 9) in vec4 turn_grown_share;   // xy: sine and cosine of the yaw; z: 0 seed to 1 grown; w: share of blades
layout(location = 10) in vec4 wind_sun_through;  // xy: wind, m at the tips; z: sun; w: sun that comes through leaves
layout(location = 11) in vec4 air;               // rgb: shown colour; a: amount
layout(location = 12) in vec4 half_tint_enlarged;  // rgb: half of what the colour is multiplied by; a: half over how
                                                   // many times its size a blade has
layout(location = 13) in vec4 becoming;  // x: how far its wood has become the next coarser level's; y: the same of the
                                         // mass of its crown; z: how far the crown is that mass; w: of that mass's size

vec3 turned(vec3 v) {
    return vec3(turn_grown_share.y * v.x + turn_grown_share.x * v.z, v.y,
                turn_grown_share.y * v.z - turn_grown_share.x * v.x);
}

// How far a part that appears at this age has unfolded: limbs slide out of the ones that bear them.
float unfolded(float age) { return clamp(turn_grown_share.z / max(age, 0.04), 0.0, 1.0); }

// Snow lies on what looks up, of plants that stand where it falls: so much it adds to their colour, which is dark.
float snow_on(vec3 normal) {
    return clamp((root_scale.y - view.eye_snow.z) * view.eye_snow.w, 0.0, 1.0) * max(normal.y - 0.28, 0.0);
}

vec3 planted(vec3 in_plant_m, float sway) {
    vec3 at_m = root_scale.xyz + root_scale.w * turned(in_plant_m);
    at_m.xz += wind_sun_through.xy * (sway * sway);
    return at_m;
}
