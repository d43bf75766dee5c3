#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Courses of tiles, boards and stones: rows of pieces, each a little lighter or darker, joints between them. What is
// smaller than a pixel fades. Over them lies what weather has left.
precision highp float;
layout(binding = 0) uniform sampler2D stains;
in vec3 shown;
in vec2 on_surface;
flat in vec4 courses;
flat in vec3 pieces;
layout(location = 0) out vec4 pixel;

void main() {
    vec2 at = on_surface * courses.xy;
    vec2 across = fwidth(at);
    float row = floor(at.y);
    at.x += fract(row * 0.618) * pieces.y;
    vec2 piece = vec2(floor(at.x), row);
    vec2 off = at - piece - 0.5;
    // Interleaved gradient noise (Jimenez 2014).
    float chance = fract(52.98 * fract(dot(piece, vec2(0.0671, 0.2537))));
    float joint = clamp(max(abs(off.x), abs(off.y)) * 10.0 - 4.0, 0.0, 1.0);
    float tone = courses.z * off.y + pieces.x * (chance - 0.5) - courses.w * joint;
    tone *= clamp(1.5 - 1.8 * max(across.x, across.y), 0.0, 1.0);
    tone += pieces.z * texture(stains, on_surface).r;
    pixel = vec4(shown + shown * tone, 1.0);
}
