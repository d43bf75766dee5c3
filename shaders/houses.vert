#version 310 es
// SPDX-License-Identifier: Apache-2.0
// What people have built: lit a vertex, its cladding patterned a pixel, its windows lit when it is dark.
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/cloud_shadow.glsl"

layout(location = 0) in vec3 at_m;
layout(location = 2) in vec4 facet_normal;
layout(location = 4) in vec4 root_colour_code;  // a: cladding, scene::Cladding; from 128: 127 times a lamp's hour
layout(location = 6) in vec2 on_surface;        // in 1/256 m along and up it

out vec4 clear_fade;    // rgb: shown without the air; a: what the air leaves of it
out vec3 air;           // rgb: shown, as much of it as lies before
out vec2 on_surface_m;
flat out vec4 courses;  // x: rows, y: columns in 1/m; z: how much each row is lighter at its top; w: strength of joints
flat out vec2 pieces;   // x: how much pieces differ; y: how far rows are shifted against each other

// Rows and columns of each cladding, in 1/m; row's lightness, joints; difference of pieces, shift.
const vec4 kCourses[8] = vec4[8](vec4(0.1, 0.1, 0.0, 0.0), vec4(0.6, 0.4, 0.0, 0.0), vec4(5.0, 0.25, 0.16, 0.0),
                                 vec4(0.1, 5.6, 0.0, 0.35), vec4(3.0, 1.9, 0.0, 0.22), vec4(3.0, 3.6, 0.34, 0.10),
                                 vec4(4.2, 2.6, 0.22, 0.14), vec4(0.9, 9.0, 0.16, 0.0));
const vec2 kPieces[8] = vec2[8](vec2(0.0, 0.0), vec2(0.05, 0.4), vec2(0.10, 0.4), vec2(0.13, 0.0), vec2(0.26, 0.45),
                                vec2(0.15, 0.5), vec2(0.20, 0.5), vec2(0.16, 0.3));

void main() {
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    float code = root_colour_code.a * 255.0;
    vec3 normal = facet_normal.xyz;
    float facing = max(dot(normal, view.to_sun.xyz), 0.0) * view.cloud_place[1].z;
    vec3 light = view.sunlight.rgb * facing + ambient_on(normal);
    vec4 haze = haze_at(at_m);
    vec3 shown = encode(root_colour_code.rgb * root_colour_code.rgb * light) * cloud_light(at_m);
    float lamp = code < 127.5 ? 0.0 : clamp((view.scales.w - (code - 128.0) / 127.0) * 40.0, 0.0, 1.0);
    shown = mix(shown, vec3(1.0, 0.78, 0.42) * view.cloud_place[1].w, lamp);
    clear_fade = vec4(shown, 1.0 - haze.a);
    air = haze.rgb * haze.a;
    on_surface_m = on_surface * (1.0 / 256.0);
    int cladding = code < 127.5 ? int(code + 0.5) : 0;
    courses = kCourses[cladding];
    pieces = kPieces[cladding];
}
