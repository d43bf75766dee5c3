#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The whole view shows what is far as it was held some frames ago, before the sky as that is held. What is held is taken
// for a sphere about the place where it was drawn; it is cut into squares so small that a pixel needs no division.
layout(location = 0) uniform mat3 way_from_clip;  // from clip xy and 1 to a way in the world, one metre deep
layout(location = 1) uniform mat3 held_from_way;  // from a way to the held picture's coordinates, times depth
layout(location = 2) uniform mat3 sky_from_view;  // from clip xy and 1 to the held sky's coordinates, times depth
layout(location = 3) uniform vec4 moved_radius;   // xyz: the eye since then, m; w: the sphere's radius, m
layout(location = 4) uniform vec3 split;          // x: what is farther on the map is held, m; yz: its depth in the
                                                  // depth buffer: y plus z over its metres
layout(location = 5) uniform int side;            // squares

out vec2 over_held;
out vec2 over_sky;

void main() {
    int square = gl_VertexID / 6;
    int vertex = gl_VertexID - 6 * square;
    int corner = vertex < 3 ? vertex : 6 - vertex;  // of two triangles: 0 1 2, 3 2 1
    vec2 at = vec2(square % side + (corner & 1), square / side + (corner >> 1));
    vec2 clip = at * (2.0 / float(side)) - 1.0;
    vec3 way = way_from_clip * vec3(clip, 1.0);
    vec3 unit = normalize(way);
    vec3 moved = moved_radius.xyz;
    float along = dot(unit, moved);
    float reach = sqrt(along * along + moved_radius.w * moved_radius.w - dot(moved, moved)) - along;
    vec3 held = held_from_way * (moved + unit * reach);
    over_held = held.xy / held.z;
    vec3 sky = sky_from_view * vec3(clip, 1.0);
    over_sky = sky.xy / sky.z;
    // Looking down, the split lies under the land.
    float depth_m = split.x / max(length(way.xz), 0.05);
    gl_Position = vec4(clip, split.y + split.z / depth_m, 1.0);
}
