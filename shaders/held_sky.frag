#version 310 es
// SPDX-License-Identifier: Apache-2.0
precision highp float;
layout(binding = 3) uniform sampler2D held;
layout(location = 1) uniform float kept;  // of its light, where the view has been dimmed since

in vec2 over_held;
layout(location = 0) out vec4 pixel;

void main() { pixel = vec4(texture(held, over_held).rgb * kept, 1.0); }
