#version 310 es
// SPDX-License-Identifier: Apache-2.0
// What people have built: lit a vertex, its cladding patterned a pixel, its windows lit when it is dark.
#include "common/view.glsl"
#include "common/night_eye.glsl"
#include "common/haze.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/cloud_shadow.glsl"

layout(location = 0) in vec3 at_m;
layout(location = 2) in vec4 facet_normal;
layout(location = 4) in vec4 root_colour_code;  // a: 8 times scene::Cladding and 7 times its wear; from 128: 127 times a
                                                // lamp's hour
layout(location = 6) in vec2 over_surface;      // in 1/256 m along and up it

out vec3 shown;
out vec2 on_surface;  // in tiles of stains
flat out vec4 courses;  // x: columns, y: rows a tile; z: how much each row is lighter at its top; w: strength of joints
flat out vec3 pieces;   // x: how much pieces differ; y: how far rows are shifted against each other; z: what stains add

const float kTile_m = 4.0;  // scene::kStainsTile_m
// Columns and rows of each cladding, in 1/m; row's lightness, joints; difference of pieces, shift, and what stains add to
// its light: runs darken a wall, crusts on stone and roofs are pale.
const vec4 kCourses[9] =
    vec4[9](vec4(0.1, 0.1, 0.0, 0.0), vec4(0.4, 0.6, 0.0, 0.0), vec4(0.25, 5.0, 0.16, 0.0), vec4(5.6, 0.1, 0.0, 0.35),
            vec4(1.9, 3.0, 0.0, 0.22), vec4(3.6, 3.0, 0.34, 0.10), vec4(2.6, 4.2, 0.22, 0.14), vec4(9.0, 0.9, 0.16, 0.0),
            vec4(8.0, 10.0, 0.2, 0.0));
const vec3 kPieces[9] = vec3[9](vec3(0.0, 0.0, 0.0), vec3(0.0, 0.0, -0.34), vec3(0.10, 0.8, -0.36),
                                vec3(0.13, 0.0, -0.40), vec3(0.26, 0.9, 0.34), vec3(0.15, 1.0, 0.30),
                                vec3(0.20, 1.0, 0.36), vec3(0.16, 0.6, -0.36), vec3(0.42, 0.7, -0.85));

void main() {
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    float code = root_colour_code.a * 255.0;
    vec3 normal = facet_normal.xyz;
    float facing = max(dot(normal, view.to_sun.xyz), 0.0) * view.cloud_place[1].z;
    vec3 light = view.sunlight.rgb * facing + ambient_on(normal);
    vec4 haze = haze_at(at_m);
    vec3 clear = encode(seen_by_night(root_colour_code.rgb * root_colour_code.rgb) * light) * cloud_light(at_m);
    float lamp = code < 127.5 ? 0.0 : clamp((view.scales.w - (code - 128.0) / 127.0) * 40.0, 0.0, 1.0);
    clear = mix(clear, vec3(1.0, 0.78, 0.42) * view.cloud_place[1].w, lamp);
    shown = mix(clear, haze.rgb, haze.a);
    on_surface = over_surface * (1.0 / (256.0 * kTile_m));
    int worn_cladding = code < 127.5 ? int(code + 0.5) : 0;
    int cladding = worn_cladding >> 3;
    float wear = float(worn_cladding & 7) * (1.0 / 7.0);
    // The air takes from the pattern what it takes from the light.
    float left = 1.0 - haze.a;
    courses = kCourses[cladding] * vec4(kTile_m, kTile_m, left, left);
    pieces = kPieces[cladding] * vec3(left, 1.0, left * (0.25 + 0.75 * wear));
}
