#version 310 es
// SPDX-License-Identifier: Apache-2.0
#include "common/view.glsl"
#include "common/encode.glsl"

layout(binding = 0) uniform sampler2D baked_light;
layout(binding = 1) uniform sampler2D ripples;  // slopes, 0.5 is level
layout(binding = 2) uniform sampler2D mirror;   // the dome seen from above: x / (1 + y), z / (1 + y)

in vec2 over_land;
in vec4 ripples_at;
in vec3 ray;
in vec4 haze;
layout(location = 0) out vec4 pixel;

void main() {
    vec4 baked = texture(baked_light, over_land);
    vec2 slope = texture(ripples, ripples_at.xy).rg + texture(ripples, ripples_at.zw).rg - 1.0;
    vec3 look = ray * inversesqrt(dot(ray, ray));
    // The mirror image of the look, pushed aside by the ripples and never below the horizon.
    vec3 away = vec3(look.xz + slope * 0.20, max(-look.y, 0.03)).xzy;
    float grazing = 1.0 - away.y;
    float reflected = 0.03 + 0.75 * grazing * grazing * grazing * grazing;
    vec3 sky = texture(mirror, away.xz / (1.0 + away.y) * 0.46 + 0.5).rgb * view.sunlight.w;
    float glitter = exp2((dot(away, view.to_sun.xyz) - 1.03) * 90.0);

    vec2 outside = max(abs(over_land - 0.5) * 60.0 - 29.5, 0.0);
    float depth_m = baked.a * 24.0 + outside.x + outside.y;
    float deep = 1.0 - exp2(-0.35 * depth_m);
    vec3 body = mix(view.shallow_colour.rgb, view.deep_colour.rgb, deep);
    float foam = clamp(0.75 - depth_m * 1.1 + slope.x * 1.5, 0.0, 1.0);
    vec3 colour = mix(body, sky, reflected) + view.sun_colour.rgb * glitter;
    colour = mix(colour, view.light_above.rgb + view.sunlight.rgb * 0.35, foam * 0.6);
    // The shore shows through.
    float covering = clamp(depth_m * 1.3 + 0.30, 0.0, 1.0);
    pixel = vec4(encode(mix(colour, haze.rgb, haze.a)), covering);
}
