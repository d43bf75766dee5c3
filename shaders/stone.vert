#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Boulders, arches, caves.
#include "common/view.glsl"
#include "common/night_eye.glsl"
#include "common/haze.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/cloud_shadow.glsl"
#include "common/lit_ground.glsl"
#include "common/beds.glsl"

layout(location = 0) in vec3 at_m;
layout(location = 2) in vec4 facet_normal;
layout(location = 4) in vec4 root_colour;  // a: how well lichen grows there

out vec3 to_pale;
out vec3 to_orange;
out vec2 over_stone;
out vec2 over_beds;
out vec3 bedded;  // what the beds scale: what is shown of the stone itself

const float kTile_m = 3.4;
const vec3 kPale = vec3(0.64, 0.67, 0.59);  // roots of linear light
const vec3 kOrange = vec3(0.72, 0.53, 0.26);
const float kDense = 0.75; // the stone shows through what covers it

void main() {
    show_ground(at_m, facet_normal.xyz, root_colour.rgb);
    vec3 stone = shown;
    vec4 haze = haze_at(at_m);
    bedded = (shown - haze.rgb * haze.a) * (0.42 * kBedded * view.scales.z);
    over_beds = 3.4 * beds_at(at_m);
    // As light as the stone is in its own light and shade.
    float brightness = 0.45 + 0.65 * max(root_colour.r, root_colour.g);
    show_ground(at_m, facet_normal.xyz, brightness * kPale);
    to_pale = kDense * root_colour.a * (shown - stone);
    show_ground(at_m, facet_normal.xyz, brightness * kOrange);
    to_orange = kDense * root_colour.a * (shown - stone);
    shown = stone;
    // Facets are flat: each takes the plane that it lies nearest to.
    vec3 n = abs(facet_normal.xyz);
    over_stone = (n.x > max(n.y, n.z) ? at_m.zy : n.y > n.z ? at_m.xz : at_m.xy) / kTile_m;
}
