// SPDX-License-Identifier: Apache-2.0
// One plant, as attributes with divisor 1: a Raspberry Pi has no storage buffers in vertex shaders.
layout(location = 8) in vec4 root_scale;      // xyz: root, m; w: of the species' size
layout(location = 9) in vec4 turn_sun_tint;   // xy: sine and cosine of the yaw; z: sun; w: tint
layout(location = 10) in vec4 grown_share_wind;  // x: 0 seed to 1 grown; y: share of the blades; zw: wind, m at the tips

vec3 turned(vec3 v) {
    return vec3(turn_sun_tint.y * v.x + turn_sun_tint.x * v.z, v.y, turn_sun_tint.y * v.z - turn_sun_tint.x * v.x);
}

// How far a part that appears at this age has unfolded: limbs slide out of the ones that bear them.
float unfolded(float age) { return clamp(grown_share_wind.x / max(age, 0.04), 0.0, 1.0); }

vec3 planted(vec3 in_plant_m, float sway) {
    vec3 at_m = root_scale.xyz + root_scale.w * turned(in_plant_m);
    at_m.xz += grown_share_wind.zw * (sway * sway);
    return at_m;
}

// Lighter and yellower, or darker and bluer.
vec3 tinted(vec3 colour) { return colour * (1.0 + turn_sun_tint.w * vec3(0.24, 0.16, -0.10)); }
