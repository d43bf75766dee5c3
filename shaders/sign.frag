#version 310 es
// SPDX-License-Identifier: Apache-2.0
precision highp float;
layout(location = 0) uniform vec4 colour;  // premultiplied
layout(location = 1) uniform vec4 shape;   // xy: half the size; z: corner radius; w: border, all pixels

in vec2 from_middle_px;
layout(location = 0) out vec4 pixel;

void main() {
    // Signed distance to a rounded rectangle, then softened over one pixel.
    vec2 q = abs(from_middle_px) - shape.xy + shape.z;
    float outside = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - shape.z;
    float cover = clamp(0.5 - outside, 0.0, 1.0);
    float hole = clamp(0.5 - (outside + shape.w), 0.0, 1.0);
    pixel = colour * (cover - (shape.w > 0.0 ? hole : 0.0));
}
