// SPDX-License-Identifier: Apache-2.0
// What the lower clouds leave of the light at a vertex, 0 to 1: a shadow's edge is softer than the ground's triangles are
// large, and a pixel is spared a fetch. Their density is a table of numbers, for a texture that a vertex fetches stalls
// a tiler's binner. The C++ mirror, for plants, is passes/cloud_shadow.hpp.
layout(std140, binding = 1) uniform CloudShadow {
    uvec4 corners[256];  // 32 x 32 samples of the tile, row by row: each with its right, its lower and its lower right one
} cloud_shadow;

float cloud_light(vec3 at_m) {
    vec2 tile = view.shadow_place.xy - view.shadow_place.zw * at_m.y + view.shadow_turn.xy * at_m.x +
                view.shadow_turn.zw * at_m.z;
    vec2 sample_at = fract(tile) * 32.0;
    ivec2 cell = min(ivec2(sample_at), 31);
    vec2 between = sample_at - vec2(cell);
    int i = cell.y * 32 + cell.x;
    vec4 corner = unpackUnorm4x8(cloud_shadow.corners[i >> 2][i & 3]);
    vec2 rows = mix(corner.xz, corner.yw, between.x);
    return 1.0 - mix(rows.x, rows.y, between.y) * view.cloud_place[0].z;
}
