// SPDX-License-Identifier: Apache-2.0
// What still water shows (scene::Mirror): one picture, seen from one place on the water. A ray that leaves it elsewhere is
// followed to the shore that stands in its bearing. The C++ mirror of the block is passes/mirror.hpp.
layout(std140, binding = 2) uniform MirrorBlock {
    vec4 place;  // xyz: where it was held up, m; w: bearing of its middle, rad
    vec4 ripple; // how a ripple's slope moves x: the picture, y: the glitter, as a power of two; z: how narrow glitter
                 // is; w: how much less bright, as a power of two
    vec4 shore_m[16];
} mirror;

float off_middle(vec2 way) {
    float off = atan(way.x, -way.y) - mirror.place.w;
    return off - 6.2831853 * floor(off * 0.1591549 + 0.5);
}

float shore_towards(vec2 way) {
    float at = clamp(off_middle(way) * 17.7777778 + 31.5, 0.0, 62.99);
    int i = int(at);
    return mix(mirror.shore_m[i >> 2][i & 3], mirror.shore_m[(i + 1) >> 2][(i + 1) & 3], at - float(i));
}

// Where the picture shows what a ray meets that leaves the water there. upward: its direction, unit.
vec2 in_mirror(vec3 at_m, vec3 upward) {
    float flat_length = max(length(upward.xz), 0.01);
    vec2 way = upward.xz / flat_length;
    float rise = upward.y / flat_length;
    float shore_m = shore_towards(way);
    // Water beyond two thirds of the way to that shore, or in another lake, counts as there: nearer to it little would
    // be seen but its foot, and behind it a ray meets it nowhere, which would show as an edge between two corners.
    vec2 from_place = at_m.xz - mirror.place.xz;
    from_place *= min(0.65 * shore_m / max(length(from_place), 0.01), 1.0);
    float along = dot(from_place, way);
    float reach = sqrt(shore_m * shore_m + along * along - dot(from_place, from_place)) - along;
    vec2 seen = from_place + way * reach;
    rise = max(rise * reach + at_m.y - mirror.place.y, 0.0) / shore_m;
    return vec2(off_middle(seen) * 0.2777778 + 0.5, rise * 1.25 / (rise + 0.25));
}
