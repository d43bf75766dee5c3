#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Two large, flat layers of cloud before the dome ("Genetic selection of parametric scenes" 2003), met by the ray in
// one division for both.
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/encode.glsl"
#include "common/dither.glsl"

layout(binding = 0) uniform sampler2D lower_clouds;  // r: density; g: lit
layout(binding = 1) uniform sampler2D upper_clouds;

in vec3 ray;
in vec3 root;
layout(location = 0) out vec4 pixel;

vec3 behind(vec3 colour, sampler2D layer, int which, vec2 per_height, float glow, float clear) {
    vec2 cloud = texture(layer, view.cloud_place[which].xy + per_height * view.cloud_place[which].z).rg;
    float opacity = cloud.r * view.cloud_place[which].w * clear;
    // Thin cloud before the sun shines: its silver lining.
    vec3 lit = mix(view.cloud_shaded[which].rgb, view.cloud_sunlit[which].rgb, cloud.g) +
               view.sun_colour.rgb * (glow * (1.0 - cloud.r));
    return mix(colour, lit, opacity);
}

void main() {
    float cos_to_sun = dot(ray, view.to_sun.xyz) * inversesqrt(dot(ray, ray));
    float glow = exp2((cos_to_sun - 1.0) * 22.0);
    float disc = clamp((cos_to_sun - view.sun_colour.w) * 24000.0, 0.0, 1.0);
    vec3 colour = root * root * view.sunlight.w + view.sun_colour.rgb * (0.30 * glow * glow + disc);

    // Divided by a little more than the height, so that layers bend down to the horizon as the earth's do.
    vec2 per_height = ray.xz / (max(ray.y, 0.0) + 0.045);
    float clear = clamp(ray.y * 14.0, 0.0, 1.0);
    colour = behind(colour, upper_clouds, 1, per_height, glow * 0.5, clear);
    colour = behind(colour, lower_clouds, 0, per_height, glow * 0.5, clear);

    float air = exp2(-max(ray.y, 0.0) * 26.0);
    colour = mix(colour, haze_towards(cos_to_sun), air);
    pixel = vec4(encode(colour) + dither(), 1.0);
}
