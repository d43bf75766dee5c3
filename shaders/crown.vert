#version 310 es
// SPDX-License-Identifier: Apache-2.0
// A crown as one mass, behind what is left of its leaves.
#include "common/view.glsl"
#include "common/night_eye.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/instance.glsl"
#include "common/leaf_light.glsl"

layout(location = 0) in vec3 position_m;
layout(location = 2) in vec2 age_sway;
layout(location = 3) in vec3 to_coarser_m;
layout(location = 4) in vec3 crown_normal;
layout(location = 5) in vec4 root_colour_shade;
layout(location = 0) uniform vec2 height_m_tiles;  // y: of the foliage's picture, a metre

out vec3 shown;
out vec3 on_blade;  // xy: in the foliage's picture; z: how far it shows

void main() {
    // It swells behind the leaves as they become fewer.
    vec3 middle_m = vec3(0.0, 0.6 * height_m_tiles.x, 0.0);
    vec3 on_crown_m = position_m + to_coarser_m * becoming.y;
    vec3 in_plant_m = mix(middle_m, on_crown_m, (0.5 + 0.45 * becoming.z) * becoming.w) * unfolded(age_sway.x);
    vec3 at_m = planted(in_plant_m, age_sway.y);
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    // Leaves lie on it as they are seen from here, and so are never drawn out.
    vec2 away = normalize(root_scale.xz - view.eye_seconds.xz);
    vec3 from_root = (at_m - root_scale.xyz) * (height_m_tiles.y / root_scale.w);
    on_blade = vec3(dot(from_root.xz, vec2(-away.y, away.x)), -0.5 * dot(from_root.xz, away) - from_root.y,
                    2.1 - 2.1 * air.a);
    // Behind leaves it is the crown's inside, which is darker.
    float lit = 0.7 + 0.3 * becoming.z;
    // Its underside sees the ground and its own shadow, its top the whole sky: so it looks round from afar.
    vec3 normal = turned(crown_normal);
    lit *= 0.38 + 0.84 * smoothstep(-0.9, 0.8, normal.y);
    shown = leaf_shown(normal, root_colour_shade * vec4(vec3(sqrt(lit)), lit));
}
