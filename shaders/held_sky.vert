#version 310 es
// SPDX-License-Identifier: Apache-2.0
// The whole view, behind all else, shows the sky as it was held some frames ago. What lies in a direction there lies in
// a direction here by a matrix: no vertex needs to follow the dome. It is cut into squares so small that a pixel needs
// no division: four corners of each have it done.
layout(location = 0) uniform mat3 held_from_view;  // from clip xy and 1 to the held picture's coordinates, times depth
layout(location = 2) uniform int side;             // squares

out vec2 over_held;

void main() {
    int square = gl_VertexID / 6;
    int vertex = gl_VertexID - 6 * square;
    int corner = vertex < 3 ? vertex : 6 - vertex;  // of two triangles: 0 1 2, 3 2 1
    vec2 at = vec2(square % side + (corner & 1), square / side + (corner >> 1));
    vec2 clip = at * (2.0 / float(side)) - 1.0;
    vec3 held = held_from_view * vec3(clip, 1.0);
    over_held = held.xy / held.z;
    gl_Position = vec4(clip, 1.0, 1.0);
}
