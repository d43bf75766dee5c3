#version 310 es
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in vec2 on_puff;
in vec4 puff;
layout(location = 0) out vec4 pixel;

void main() {
    float within = max(1.0 - dot(on_puff, on_puff), 0.0);
    pixel = vec4(puff.rgb, puff.a * within * within);
}
