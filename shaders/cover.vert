#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Grass, cushions, flowers and small stones. A tuft shows what the ground under it shows, darker at the root and lighter
// at the tips, so that it melts into it: no light is worked out here.
#include "common/view.glsl"

layout(location = 0) in vec3 at;          // in a tuft of radius and height 1
layout(location = 1) in vec3 aside;       // to the blade's rim, in heights
layout(location = 2) in vec2 tone_accent; // 1/2: the ground's own; how far it has the flowers' colour
layout(location = 3) in float rank;       // its place in the shuffled order, 0 to 1
layout(location = 8) in vec3 root_m;
layout(location = 9) in vec4 turn_size;   // xy: cosine and sine of the yaw, 1/2 is 0; z: radius, m; w: height, m, halved
layout(location = 10) in vec4 ground_lit; // rgb: shown, of the ground; a: shown, of white; less what the air hides
layout(location = 11) in vec3 veil;       // shown, of the air before it
layout(location = 0) uniform vec4 fade;   // x: whole to this distance, m; y: 1 / where it ends, 1/m; z: grown; w: gusts
layout(location = 1) uniform vec4 blossom; // rgb: shown

out vec3 shown;

void main() {
    float distance_m = distance(root_m, view.eye_seconds.xyz);
    // Of its blades a prefix stands for all, each wider; those about to leave shrink first.
    float share = min(fade.x / distance_m, 1.0);
    share *= sqrt(share);
    float leaving = clamp((1.0 - rank / share) * 5.0, 0.0, 1.0);
    float ending = clamp(3.2 - 3.2 * distance_m * fade.y, 0.0, 1.0);
    vec2 turn = 2.0 * turn_size.xy - 1.0;
    float height_m = 2.0 * turn_size.w * ending * fade.z * (0.35 + 0.65 * leaving);
    float wide = leaving * min(inversesqrt(share), 3.2 - 1.9 * tone_accent.y);
    vec3 in_tuft_m = vec3(at.x * turn_size.z, at.y * height_m, at.z * turn_size.z) + aside * (wide * height_m);
    vec3 at_m = root_m + vec3(turn.x * in_tuft_m.x + turn.y * in_tuft_m.z, in_tuft_m.y,
                              turn.x * in_tuft_m.z - turn.y * in_tuft_m.x);
    // Gusts travel; a stone has no tips.
    float phase = 1.9 * view.eye_seconds.w - 0.23 * root_m.x - 0.17 * root_m.z;
    float gust = sin(phase) + 0.6 * sin(2.3 * phase + 9.0 * rank);
    at_m.xz += vec2(0.8, 0.5) * (gust * fade.w * at.y * at.y * height_m);
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    vec3 own = mix(ground_lit.rgb * (2.0 * tone_accent.x), blossom.rgb * ground_lit.a, tone_accent.y);
    shown = own + veil;
}
