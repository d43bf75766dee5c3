#version 310 es
// SPDX-License-Identifier: Apache-2.0
// A crown as one mass, behind what is left of its leaves.
#include "common/view.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/instance.glsl"
#include "common/leaf_light.glsl"

layout(location = 0) in vec3 position_m;
layout(location = 2) in vec2 age_sway;
layout(location = 3) in vec3 to_coarser_m;
layout(location = 4) in vec3 crown_normal;
layout(location = 5) in vec4 root_colour_shade;
layout(location = 0) uniform float height_m;

out vec3 shown;

void main() {
    // It swells behind the leaves as they become fewer.
    vec3 middle_m = vec3(0.0, 0.6 * height_m, 0.0);
    vec3 on_crown_m = position_m + to_coarser_m * becoming.y;
    vec3 in_plant_m = mix(middle_m, on_crown_m, (0.5 + 0.45 * becoming.z) * becoming.w) * unfolded(age_sway.x);
    gl_Position = view.clip_from_world * vec4(planted(in_plant_m, age_sway.y), 1.0);
    shown = leaf_shown(turned(crown_normal), root_colour_shade);
}
