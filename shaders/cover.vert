#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Grass, cushions, flowers and small stones. A tuft shows what the ground under it shows, darker at the root and lighter
// at the tips, so that it melts into it: no light is worked out here.
#include "common/view.glsl"

layout(location = 0) in vec3 at;          // in a tuft of radius and height 1
layout(location = 1) in vec3 aside;       // to the blade's rim, in radii; up in heights
layout(location = 2) in vec2 tone_accent; // 1/2: the ground's own; how far it has the flowers' colour
layout(location = 3) in float rank;       // its place in the shuffled order, 0 to 1
layout(location = 8) in vec3 root_m;
layout(location = 9) in vec4 turn_size;   // xy: cosine and sine of the yaw, times the radius, m; z: height, m; w: how
                                          // many times its width a blade has, since fewer stand for all
layout(location = 10) in vec4 ground_lit; // rgb: shown, of the ground; a: shown, of white; less what the air hides
layout(location = 11) in vec4 veil_gust;  // rgb: shown, of the air before it; a: the gust there, 1/2: none
layout(location = 0) uniform vec4 blossom; // rgb: shown; a: of a gust, to a blade's height

out vec3 shown;

void main() {
    // Those of a prefix that are about to leave shrink first.
    float leaving = clamp(5.0 - 5.0 * rank * turn_size.w * turn_size.w, 0.0, 1.0);
    float wide = leaving * min(turn_size.w, 3.2 - 1.9 * tone_accent.y);
    float height_m = turn_size.z * (0.35 + 0.65 * leaving);
    vec3 in_tuft = at + aside * wide;
    float sway_m = (2.0 * veil_gust.a - 1.0) * blossom.a * at.y * at.y * height_m;
    vec3 at_m = root_m + vec3(turn_size.x * in_tuft.x + turn_size.y * in_tuft.z + sway_m, in_tuft.y * height_m,
                              turn_size.x * in_tuft.z - turn_size.y * in_tuft.x + 0.6 * sway_m);
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    // What is far melts into the ground, though not all of it: tips that stand for many would light up as a field of
    // its own.
    float tone = 1.0 + (2.0 * tone_accent.x - 1.0) / max(0.6 * min(turn_size.w, 4.5), 1.0);
    vec3 own = mix(ground_lit.rgb * tone, blossom.rgb * ground_lit.a, tone_accent.y);
    shown = own + veil_gust.rgb;
}
