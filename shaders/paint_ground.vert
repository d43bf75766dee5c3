#version 310 es
// SPDX-License-Identifier: Apache-2.0
// One triangle over the whole picture.
out vec2 over_land;

void main() {
    vec2 corner = vec2((gl_VertexID & 1) << 2, (gl_VertexID & 2) << 1);
    over_land = 0.5 * corner;
    gl_Position = vec4(corner - 1.0, 0.0, 1.0);
}
