// SPDX-License-Identifier: Apache-2.0
// Clouds as they are seen from the land, and a large, flat layer above them ("Genetic selection of parametric scenes"
// 2003), laid over each other as numbers before there is any colour.
layout(binding = 0) uniform sampler2D lower_clouds;  // r: opacity; g: light, weighted by it
layout(binding = 1) uniform sampler2D upper_clouds;  // r: opacity; g: lit

// tiles: where the ray meets the lower clouds and the upper layer. x: opacity; y: light, weighted by it.
vec2 clouds_at(vec4 tiles) {
    vec2 lower = texture(lower_clouds, tiles.xy).rg;
    vec2 upper = texture(upper_clouds, tiles.zw).rg;
    float far_opacity = upper.r - upper.r * lower.r;
    float light = lower.g + far_opacity * (upper.g * view.cloud_shaded.w + view.cloud_gain.w);
    return vec2(lower.r + far_opacity, light);
}
