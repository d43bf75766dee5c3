// SPDX-License-Identifier: Apache-2.0
// Air: transmittance exp(-d / distance), thinner with height, brighter toward the glow; below it a layer of mist. The sky
// uses the same colours at the horizon, so that a far ridge dissolves into it. The C++ mirror, for plants, is
// passes/air.hpp.

vec3 haze_towards(float cos_to_glow) {
    float facing = max(0.5 + 0.5 * cos_to_glow, 0.0);
    facing *= facing;
    return mix(view.haze_colour.rgb, view.haze_sunward.rgb, facing * facing);
}

// The mist's density, 0 to 1, as the mean over the heights between the eye and a point.
float mist_between(float height_m) {
    float eye = max(view.eye_seconds.y - view.mist.y, 0.0) * view.mist.z;
    float end = max(height_m - view.mist.y, 0.0) * view.mist.z;
    float span = abs(end - eye);
    float above = span > 0.02 ? abs(exp2(-eye) - exp2(-end)) * 1.442695 / span : exp2(-0.5 * (eye + end));
    // What of the way lies under the mist's level has all of it.
    float share = (span + 0.001) / (abs(height_m - view.eye_seconds.y) * view.mist.z + 0.001);
    return mix(1.0, above, min(share, 1.0));
}

// rgb: the air's shown colour; a: how much of it lies between the eye and the point.
vec4 haze_at(vec3 at_m) {
    vec3 ray = at_m - view.eye_seconds.xyz;
    float distance_m = length(ray);
    float between_m = max(0.5 * (at_m.y + view.eye_seconds.y), 0.0);
    float depth = distance_m * view.haze_colour.w * exp2(-between_m * view.haze_sunward.w);
    depth += distance_m * view.mist.x * mist_between(at_m.y);
    // Whatever the weather, the world's rim is not seen.
    float rim = clamp((distance_m - 6000.0) * (1.0 / 4500.0), 0.0, 1.0);
    float amount = max(1.0 - exp2(-depth), rim * rim);
    return vec4(haze_towards(dot(ray, view.to_glow.xyz) / max(distance_m, 1e-3)), amount);
}
