#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/encode.glsl"
#include "common/ambient.glsl"
#include "common/instance.glsl"

layout(location = 0) in vec3 position_m;
layout(location = 1) in vec3 age_sways;  // y: sway; z: on the coarser level
layout(location = 5) in vec3 to_coarser_m;
layout(location = 2) in vec3 wood_normal;
layout(location = 3) in vec4 grain;  // xyz: along the limb; w: which way the bark runs around it
layout(location = 4) in vec2 bark_tile;
layout(location = 0) uniform vec4 bark;   // rgb: twice the colour, as it is seen at this hour; w: 1 / height of the
                                          // species, 1/m
layout(location = 1) uniform vec2 crown;  // x: how much of the light its leaves take; y: where it begins, of the height
layout(location = 2) uniform vec3 sunlight;  // as it colours wood

out vec3 shown;     // of the bark, less what the air hides
out vec3 veil;      // of the air before it
out vec2 on_bark;
out vec2 slant;     // of the light along the bark's two ways: what its relief makes of it

void main() {
    // What leaves is on the coarser level's surface before that takes its place.
    float leaving = becoming.x;
    vec3 in_plant_m = position_m + to_coarser_m * leaving;
    float sway = mix(age_sways.y, age_sways.z, leaving);
    gl_Position = view.clip_from_world * vec4(planted(in_plant_m * unfolded(age_sways.x), sway), 1.0);

    vec3 normal = turned(wood_normal);
    vec3 along = turned(grain.xyz);
    // A little of the light comes round the limb, as on rough bark; the foot stands in its neighbours' shade.
    float facing = max(dot(normal, view.to_sun.xyz) * 0.85 + 0.15, 0.0);
    float high = position_m.y * bark.w;
    float foot = min(0.55 + 3.0 * high, 1.0);
    // Limbs among leaves stand in their shade: lit as the trunk is, they would lie before the crown. The topmost stand
    // out of it.
    float left = 1.0 - crown.x * clamp((high - crown.y) * 4.0, 0.0, 1.0) * clamp(3.6 - 3.0 * high, 0.0, 1.0);
    vec3 light = (sunlight * (facing * wind_sun_through.z) + ambient_on(normal) * foot) * left;
    vec3 colour = bark.rgb * half_tint_enlarged.rgb + snow_on(normal);
    shown = encode_root(sqrt(colour * light)) * (1.0 - air.a);
    veil = air.rgb * air.a;
    on_bark = bark_tile;
    vec3 toward = view.to_sun.xyz * (0.35 + 0.65 * wind_sun_through.z) + vec3(0.0, 0.35, 0.0);
    slant = vec2(dot(cross(along, normal), toward) * grain.w, dot(along, toward));
}
