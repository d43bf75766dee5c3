#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Courses of tiles, boards and stones: rows of pieces, each a little lighter or darker, joints between them. What is
// smaller than a pixel fades.
precision highp float;
in vec4 clear_fade;
in vec3 air;
in vec2 on_surface_m;
flat in vec4 courses;
flat in vec2 pieces;
layout(location = 0) out vec4 pixel;

void main() {
    vec2 at = on_surface_m.yx * courses.xy;
    float width = max(fwidth(at.x), fwidth(at.y));
    float row = floor(at.x);
    at.y += fract(row * 0.618) * pieces.y * 2.0;
    vec2 piece = vec2(row, floor(at.y));
    vec2 within = at - piece;
    vec2 p = fract(piece * vec2(0.1031, 0.2137));
    float chance = fract((p.x + p.y) * (p.x * 37.3 + p.y * 17.9 + 3.1));
    vec2 rim = clamp((abs(within - 0.5) - 0.40) * 10.0, 0.0, 1.0);
    float tone = courses.z * (within.x - 0.5) + pieces.x * (chance - 0.5) - courses.w * max(rim.x, rim.y);
    tone *= clamp(1.5 - 1.8 * width, 0.0, 1.0);
    pixel = vec4(clear_fade.rgb * (1.0 + tone) * clear_fade.a + air, 1.0);
}
