#version 310 es
// SPDX-License-Identifier: Apache-2.0
precision highp float;
layout(binding = 0) uniform sampler2D picture;  // premultiplied, encoded as the display wants it
layout(location = 0) uniform vec4 colour;       // premultiplied
layout(location = 1) uniform vec4 shape;        // xy: half the size, pixels

in vec2 from_middle_px;
layout(location = 0) out vec4 pixel;

void main() { pixel = texture(picture, vec2(0.5, -0.5) * from_middle_px / shape.xy + 0.5) * colour; }
