#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/instance.glsl"

layout(location = 0) in vec3 site_m;
layout(location = 1) in vec3 corner_m;
layout(location = 2) in vec2 age_sway;
layout(location = 3) in float rank;           // the blade's place in the shuffled order, 0 to 1
layout(location = 4) in vec4 leaf_normal;
layout(location = 5) in vec4 root_colour_shade;  // rgb: square root of the colour; a: light through the own crown

out vec3 encoded;

// A share of the blades stands for all of them, each enlarged; those about to leave shrink first, so none pops.
float blade_scale(float grown) {
    float share = grown_share_wind.y;
    float leaving = clamp((share - rank) / (0.15 * share), 0.0, 1.0);
    float enlarged = inversesqrt(share);
    return grown * leaving * enlarged;
}

void main() {
    float grown = unfolded(age_sway.x);
    vec3 in_plant_m = site_m * grown + corner_m * blade_scale(grown);
    float flutter = 0.012 * sin(view.eye_seconds.w * 4.3 + dot(site_m, vec3(17.0, 11.0, 13.0)));
    vec3 at_m = planted(in_plant_m, age_sway.y) + vec3(0.0, flutter * age_sway.y * root_scale.w, 0.0);
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);

    vec3 normal = turned(leaf_normal.xyz);
    vec3 colour = tinted(root_colour_shade.rgb * root_colour_shade.rgb);
    float shade = root_colour_shade.a;
    float sun = turn_sun_tint.z * shade;
    float facing = max(dot(normal, view.to_sun.xyz) * 0.75 + 0.25, 0.0);
    vec3 to_eye = normalize(view.eye_seconds.xyz - at_m);
    float against = max(-dot(to_eye, view.to_sun.xyz), 0.0);
    // Light that comes through a leaf has lost its blue.
    vec3 through = vec3(0.95, 1.0, 0.30) * (0.9 * against * against * against);
    vec3 light = view.sunlight.rgb * (facing + through) * sun + ambient_on(normal) * (0.35 + 0.65 * shade);
    vec4 haze = haze_at(at_m);
    encoded = encode(mix(colour * light, haze.rgb, haze.a));
}
