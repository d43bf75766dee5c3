#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Rain and snow: drops in a box that goes with the eye, each at a place that does not.
#include "common/view.glsl"

layout(location = 0) in vec3 home;    // in the box, 0 to 1
layout(location = 1) in vec2 corner;  // -1 to 1
layout(location = 0) uniform vec4 speed_width;   // xyz: m/s; w: m
layout(location = 1) uniform vec4 streak_wander; // x: s; y: m; z: radians a pixel
layout(location = 2) uniform vec4 shown_opacity;

out vec2 on_drop;
out vec4 drop;

const vec3 kBox_m = vec3(26.0, 16.0, 26.0);
const float kSharp = 2.0;  // times the least width that is drawn

void main() {
    vec3 eye = view.eye_seconds.xyz;
    float seconds = view.eye_seconds.w;
    vec3 place = fract(home + (speed_width.xyz * seconds - eye) / kBox_m) - 0.5;
    vec3 at_m = eye + place * kBox_m;
    at_m.xz += streak_wander.y * sin(seconds * 1.3 + home.yz * 40.0);
    vec3 ray = at_m - eye;
    float distance_m = max(length(ray), 0.1);
    float width_m = speed_width.w;
    // Never thinner than a pixel; what it would hide less, it lets through.
    float drawn_m = max(width_m, distance_m * streak_wander.z);
    vec3 along = speed_width.xyz * (streak_wander.x * mix(0.6, 1.2, fract(home.y * 23.0)));
    vec3 ahead = ray / distance_m;
    vec3 lengthwise = streak_wander.x > 0.0 ? along : cross(normalize(vec3(ahead.z, 0.0, -ahead.x)), ahead) * drawn_m;
    vec3 sideways = normalize(cross(lengthwise, ahead)) * drawn_m;
    gl_Position = view.clip_from_world * vec4(at_m + lengthwise * corner.y + sideways * corner.x, 1.0);
    // Neither before one's nose, where a drop would be a stroke over the picture, nor at the box's end.
    float edge = max(max(abs(place.x), abs(place.y)), abs(place.z));
    float seen = clamp(distance_m * 0.25 - 0.9, 0.0, 1.0) * clamp(5.0 - 10.0 * edge, 0.0, 1.0);
    // A flake near the eye is out of focus: the larger it is drawn, the fainter.
    float sharp = streak_wander.x > 0.0 ? 1.0 : min(kSharp * distance_m * streak_wander.z / drawn_m, 1.0);
    // Drops of one brightness would read as hatching: few are bright, most are a shimmer.
    float bright = streak_wander.x > 0.0 ? mix(0.3, 1.0, fract(home.x * 37.0 + home.z * 17.0)) : 1.0;
    drop = vec4(shown_opacity.rgb, shown_opacity.a * bright * seen * sharp * width_m / drawn_m);
    on_drop = streak_wander.x > 0.0 ? vec2(corner.x, 0.6 * corner.y) : corner;
}
