// SPDX-License-Identifier: Apache-2.0
// Two large, flat layers of cloud ("Genetic selection of parametric scenes" 2003), laid over each other as numbers before
// there is any colour.
layout(binding = 0) uniform sampler2D lower_clouds;  // r: opacity; g: lit
layout(binding = 1) uniform sampler2D upper_clouds;

// tiles: where the ray meets the lower layer and the upper one. x: opacity; y: light, weighted by it.
vec2 clouds_at(vec4 tiles) {
    vec2 lower = texture(lower_clouds, tiles.xy).rg;
    vec2 upper = texture(upper_clouds, tiles.zw).rg;
    float far_opacity = upper.r - upper.r * lower.r;
    float light = lower.r * lower.g + far_opacity * (upper.g * view.cloud_shaded.w + view.cloud_gain.w);
    return vec2(lower.r + far_opacity, light);
}
