#version 310 es
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec2 clip;
layout(location = 1) in vec2 corner;  // from the sign's middle, pixels; y up

out vec2 from_middle_px;

void main() {
    from_middle_px = corner;
    gl_Position = vec4(clip, 0.0, 1.0);
}
