#version 310 es
// SPDX-License-Identifier: Apache-2.0
// One triangle over the whole picture, which shows a part of another: corner pixels are that part's corner pixels, so
// that nothing beyond it is ever mixed in.
layout(location = 0) uniform vec4 part;  // of the other: xy where it begins, zw its size

out vec2 over_other;

void main() {
    vec2 corner = vec2((gl_VertexID & 1) << 2, (gl_VertexID & 2) << 1);
    over_other = part.xy + 0.5 * corner * part.zw;
    gl_Position = vec4(corner - 1.0, 0.0, 1.0);
}
