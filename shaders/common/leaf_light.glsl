// SPDX-License-Identifier: Apache-2.0
// Leaves in the light, as shown through the air. shade: of the crown itself, in root_colour's a.
vec3 leaf_shown(vec3 normal, vec4 root_colour_shade) {
    float shade = root_colour_shade.a;
    // Twice the light, for the tint is halved.
    float facing = max(dot(normal, view.to_sun.xyz) * 1.5 + 0.5, 0.0) * wind_sun_through.z;
    // Light that comes through a leaf has lost its blue.
    vec3 sun = view.sunlight.rgb * (facing + vec3(1.9, 2.0, 0.6) * wind_sun_through.w);
    // Some of what falls on its back comes through it as well: one that looks down is not black.
    vec3 light = sun * shade + ambient_on(normal) * (0.24 + 2.2 * shade);
    vec3 colour = root_colour_shade.rgb * root_colour_shade.rgb * half_tint_enlarged.rgb + 0.5 * snow_on(normal);
    return mix(encode_root(sqrt(leaf_seen_by_night(colour) * light)), air.rgb, air.a);
}
