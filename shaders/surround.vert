#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The country around the land, to the horizon.
#include "common/view.glsl"
#include "common/night_eye.glsl"
#include "common/haze.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/cloud_shadow.glsl"
#include "common/grid.glsl"

layout(location = 2) in vec4 land_normal;
layout(location = 4) in vec3 root_colour;

out vec3 bare;  // shown, what air leaves of it
out vec3 veil;  // shown, of the air before it
out vec4 over_grain;
out vec2 grains;

const vec4 kTiles = vec4(vec2(1.0 / 210.0), vec2(1.0 / 690.0));  // 1/m
// As scene/withering.hpp has it: what is green turns to straw of its lightness.
const vec3 kStraw = vec3(1.38, 1.04, 0.62);

const float kSoft = 0.32;
const float kStone = 0.6;

void main() {
    vec3 at_m = grid_place();
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    vec3 light =
        view.sunlight.rgb * max(dot(land_normal.xyz, view.to_sun.xyz), 0.0) + ambient_on(land_normal.xyz);
    vec3 albedo = root_colour * root_colour;
    vec2 green = clamp((albedo.gg - vec2(0.85, 1.0) * albedo.rb) / max(vec2(0.3, 0.4) * albedo.g, 1e-4), 0.0, 1.0);
    vec3 straw = dot(albedo, vec3(0.2126, 0.7152, 0.0722)) * kStraw;
    albedo = mix(albedo, straw, green.x * green.y * view.cloud_place[0].y);
    vec4 haze = haze_at(at_m);
    bare = encode(seen_by_night(albedo) * light) * (cloud_light(at_m) * (1.0 - haze.a));
    veil = haze.rgb * haze.a;
    // Turned, so that the two sizes do not line up.
    over_grain = kTiles * vec4(at_m.xz, 0.8 * at_m.x - 0.6 * at_m.z, 0.6 * at_m.x + 0.8 * at_m.z);
    // The normals are of hills that are modelled steeper than they are.
    float steep = clamp(4.5 - 5.0 * land_normal.y, 0.0, 1.0);
    // Snow lies smooth: what is grass's grain would be dirt in it.
    grains = vec2(kSoft * (1.0 - steep), kStone * steep) * (1.0 - 0.75 * smoothstep(0.35, 0.7, albedo.b));
}
