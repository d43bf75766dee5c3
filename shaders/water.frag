#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Water: what it mirrors, moved by ripples that go with the current or the wind: two pictures of them, each carried off
// and let go in turn, shown while they are whole.
#include "common/view.glsl"
#include "common/mirror.glsl"

layout(binding = 0) uniform sampler2D ground;   // a: how deep the water over it looks, 0 to 1
layout(binding = 1) uniform sampler2D ripples;  // r: slope, 0.5 is level; g: the same of gusts, which go with the wind
layout(binding = 2) uniform sampler2D picture;  // rgb: shown, of what is mirrored

in vec2 over_land;
in float drifted;
in vec3 before;
in vec3 mirrored;
in float glitter;
in float white;
in vec4 carried;     // xy, zw: where in the ripples, of both pictures
flat in float turn;  // how much of the second is shown
layout(location = 0) out vec4 pixel;

void main() {
    float deep = texture(ground, over_land).a;
    float ripple = mix(texture(ripples, carried.xy).r, texture(ripples, carried.zw).r, turn);
    float slope = ripple + texture(ripples, vec2(drifted, over_land.y)).g;  // 1: level
    // A ripple that leans away shows what is higher, and more of it: within a slope of a tenth Fresnel's share changes by
    // its half. One that leans just so shows the sun, whatever the gust: a gust tilts a bay.
    vec3 sky = texture(picture, vec2(mirrored.x, slope * mirror.ripple.x + mirrored.y)).rgb;
    float share = (slope - 0.11) * mirrored.z + exp2(ripple * mirror.ripple.y + glitter);
    float foam = max(white * slope - deep * 13.0, 0.0) * view.mirrored.w;
    // The bed shows through where it is near, and at the very shore there is only a film. The target clamps.
    pixel = vec4(sky * share + before + foam, deep * 1.4 + (min(deep * 14.0, 0.25) + foam));
}
