// SPDX-License-Identifier: Apache-2.0
// Air: transmittance exp(-d / distance), thinner with height, brighter toward the sun. The sky uses the same colours
// at the horizon, so that a far ridge dissolves into it. The C++ mirror, for plants, is passes/air.hpp.

vec3 haze_towards(float cos_to_sun) {
    float facing = max(0.5 + 0.5 * cos_to_sun, 0.0);
    facing *= facing;
    return mix(view.haze_colour.rgb, view.haze_sunward.rgb, facing * facing);
}

// rgb: the air's shown colour; a: how much of it lies between the eye and the point.
vec4 haze_at(vec3 at_m) {
    vec3 ray = at_m - view.eye_seconds.xyz;
    float distance_m = length(ray);
    float between_m = max(0.5 * (at_m.y + view.eye_seconds.y), 0.0);
    float depth = distance_m * view.haze_colour.w * exp2(-between_m * view.haze_sunward.w);
    // Whatever the weather, the world's rim is not seen.
    float rim = clamp((distance_m - 6000.0) * (1.0 / 4500.0), 0.0, 1.0);
    float amount = max(1.0 - exp2(-depth), rim * rim);
    return vec4(haze_towards(dot(ray, view.to_sun.xyz) / max(distance_m, 1e-3)), amount);
}
