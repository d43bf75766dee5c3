// SPDX-License-Identifier: Apache-2.0
// Two large, flat layers of cloud ("Genetic selection of parametric scenes" 2003), met by the ray in one division for
// both and laid over each other as numbers before there is any colour.
layout(binding = 0) uniform sampler2D lower_clouds;  // r: density; g: lit
layout(binding = 1) uniform sampler2D upper_clouds;

// x: opacity; y: light, weighted by it.
vec2 clouds_along(vec3 ray) {
    // Divided by a little more than the height, so that layers bend down to the horizon as the earth's do.
    vec2 per_height = ray.xz / (max(ray.y, 0.0) + 0.045);
    vec2 lower = texture(lower_clouds, view.cloud_place[0].xy + per_height * view.cloud_place[0].z).rg;
    vec2 upper = texture(upper_clouds, view.cloud_place[1].xy + per_height * view.cloud_place[1].z).rg;
    float near_opacity = lower.r * view.cloud_place[0].w;
    float far_opacity = upper.r * view.cloud_place[1].w;
    far_opacity -= far_opacity * near_opacity;
    float light = near_opacity * lower.g + far_opacity * (upper.g * view.cloud_shaded.w + view.cloud_gain.w);
    return vec2(near_opacity + far_opacity, light);
}
