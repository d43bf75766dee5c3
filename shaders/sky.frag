#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Two large, flat layers of cloud before the dome ("Genetic selection of parametric scenes" 2003), met by the ray in
// one division for both and laid over each other as numbers before there is any colour.
#include "common/view.glsl"
#include "common/dither.glsl"

layout(binding = 0) uniform sampler2D lower_clouds;  // r: density; g: lit
layout(binding = 1) uniform sampler2D upper_clouds;

in vec3 ray;
in vec4 behind;
layout(location = 0) out vec4 pixel;

void main() {
    float cos_to_sun = dot(ray, view.to_sun.xyz) * inversesqrt(dot(ray, ray));
    float glow = exp2(cos_to_sun * 22.0 - 22.0);
    float disc = clamp((cos_to_sun - view.sun_colour.w) * 24000.0, 0.0, 1.0);

    // Divided by a little more than the height, so that layers bend down to the horizon as the earth's do.
    vec2 per_height = ray.xz / (max(ray.y, 0.0) + 0.045);
    vec2 lower = texture(lower_clouds, view.cloud_place[0].xy + per_height * view.cloud_place[0].z).rg;
    vec2 upper = texture(upper_clouds, view.cloud_place[1].xy + per_height * view.cloud_place[1].z).rg;
    float near_opacity = lower.r * view.cloud_place[0].w;
    float far_opacity = upper.r * view.cloud_place[1].w * (1.0 - near_opacity);
    float light = near_opacity * lower.g + far_opacity * (upper.g * view.cloud_shaded.w + view.cloud_gain.w);
    float opacity = (near_opacity + far_opacity) * behind.a;
    // Thin cloud before the sun shines: its silver lining.
    light = light * behind.a + glow * (opacity - opacity * opacity);

    vec3 sky = behind.rgb + view.sun_colour.rgb * (0.25 * glow * glow + disc);
    vec3 shown = sky * (1.0 - opacity) + view.cloud_shaded.rgb * opacity + view.cloud_gain.rgb * light;
    pixel = vec4(shown + dither(), 1.0);
}
