#version 310 es
// SPDX-License-Identifier: Apache-2.0
// One triangle over the whole picture, which shows a part of another: corner pixels are that part's corner pixels, so
// that nothing beyond it is ever mixed in.
#include "common/whole_picture.glsl"

layout(location = 0) uniform vec4 part;  // of the other: xy where it begins, zw its size

out vec2 over_other;

void main() {
    vec2 corner = corner_of_whole();
    over_other = part.xy + corner * part.zw;
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
