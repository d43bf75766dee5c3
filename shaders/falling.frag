#version 310 es
// SPDX-License-Identifier: Apache-2.0
precision highp float;
in vec2 on_drop;
in vec4 drop;
layout(location = 0) out vec4 pixel;

void main() { pixel = vec4(drop.rgb, drop.a * max(1.0 - dot(on_drop, on_drop), 0.0)); }
