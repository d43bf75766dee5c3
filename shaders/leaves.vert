#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/instance.glsl"
#include "common/leaf_light.glsl"

layout(location = 0) in vec3 site_m;
layout(location = 1) in vec3 corner_m;
layout(location = 2) in vec2 age_sway;
layout(location = 3) in float rank;  // the blade's place in the shuffled order, 0 to 1
layout(location = 4) in vec4 leaf_normal;
layout(location = 5) in vec4 root_colour_shade;  // rgb: square root of the colour; a: light through the own crown
layout(location = 6) in vec2 blade;  // from the midrib to the rim, from the foot to the tip

layout(location = 0) uniform vec2 foliage_aside_m;  // x: 1 where its picture is of many leaves, 0 of one; y: how far a
                                                    // copy's tip may lie from the blade's

out vec3 shown;
out vec3 on_blade;

// A share of the blades stands for all of them, each enlarged; those about to leave shrink first, so none pops. Near by
// there are copies, all smaller, which come as they would leave: copy 0 is the blades themselves.
float blade_scale(float grown, float copy) {
    float share = turn_grown_share.w - 2.0 * copy;
    float leaving = clamp((1.0 - rank / share) * 6.5, 0.0, 1.0);
    return grown * leaving * 0.5 / half_tint_enlarged.a;
}

// A copy fans out from the blade's own foot, each blade's another way.
vec3 fanned(vec3 from_site_m, float copy) {
    vec3 way = fract(site_m * (vec3(7.3, 9.1, 5.7) * copy)) * 2.0 - 1.0;
    float aside_m = min(foliage_aside_m.y * min(copy, 1.0), dot(abs(from_site_m), vec3(0.6)));
    return from_site_m + way * aside_m;
}

void main() {
    // A blade that stands for many shows many; where one picture takes the other's place neither shows.
    float times = 0.5 / half_tint_enlarged.a;
    vec3 own = vec3(blade, clamp(3.0 - 1.78 * times, 0.0, 1.0));
    vec3 many = vec3(blade * (0.2 * times) + rank * vec2(37.0, 11.0), clamp(1.5 * times - 2.53, 0.0, 1.0));
    on_blade = mix(own, many, foliage_aside_m.x);
    on_blade.z -= on_blade.z * air.a;  // the air hides it too
    float grown = unfolded(age_sway.x);
    float copy = floor(0.5 * turn_grown_share.w);
    vec3 in_plant_m = site_m * grown + fanned(corner_m * blade_scale(grown, copy), copy);
    float flutter = 0.012 * sin(view.eye_seconds.w * 4.3 + dot(site_m, vec3(17.0, 11.0, 13.0)));
    in_plant_m.y += flutter * age_sway.y;
    gl_Position = view.clip_from_world * vec4(planted(in_plant_m, age_sway.y), 1.0);

    shown = leaf_shown(turned(leaf_normal.xyz), root_colour_shade);
}
