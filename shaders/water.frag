#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/encode.glsl"

layout(binding = 0) uniform sampler2D ground;   // a: depth of water over it, 1 is 24 m
layout(binding = 1) uniform sampler2D ripples;  // slopes and what they are a quarter turn later, 0.5 is level
layout(binding = 2) uniform sampler2D mirror;   // the dome seen from above: x / (1 + y), z / (1 + y)

in vec2 over_land;
in vec2 ripples_at;
in vec3 ray;
in vec4 haze;
layout(location = 0) out vec4 pixel;

void main() {
    vec4 both = texture(ripples, ripples_at) - 0.5;
    vec2 slope = 2.0 * (both.rg * view.shallow_colour.w + both.ba * view.deep_colour.w);
    vec3 look = ray * inversesqrt(dot(ray, ray));
    // The mirror image of the look, pushed aside by the ripples and never below the horizon.
    vec3 away = vec3(look.xz + slope * 0.20, max(-look.y, 0.03)).xzy;
    float grazing = 1.0 - away.y;
    float reflected = 0.03 + 0.75 * grazing * grazing * grazing * grazing;
    vec3 root = texture(mirror, away.xz / (1.0 + away.y) * 0.46 + 0.5).rgb;
    vec3 sky = root * root * view.sunlight.w;
    float glitter = exp2((dot(away, view.to_sun.xyz) - 1.03) * 90.0);

    vec2 outside = max(abs(over_land - 0.5) * 60.0 - 29.5, 0.0);
    float depth_m = texture(ground, over_land).a * 24.0 + outside.x + outside.y;
    float deep = 1.0 - exp2(-0.35 * depth_m);
    vec3 body = mix(view.shallow_colour.rgb, view.deep_colour.rgb, deep);
    float foam = clamp(0.9 - depth_m * 2.4 + slope.x * 0.5, 0.0, 1.0);
    vec3 colour = mix(body, sky, reflected) + view.sun_colour.rgb * glitter;
    colour = mix(colour, view.light_above.rgb + view.sunlight.rgb * 0.35, foam * 0.6);
    // The shore shows through.
    float covering = clamp(depth_m * 1.3 + 0.30, 0.0, 1.0);
    pixel = vec4(encode(mix(colour, haze.rgb, haze.a)), covering);
}
