#version 310 es
// SPDX-License-Identifier: Apache-2.0
precision highp float;
layout(binding = 3) uniform sampler2D held_sky;
layout(binding = 4) uniform sampler2D held_distance;  // rgb: shown, times alpha; and the lights of the sky
layout(location = 6) uniform vec2 kept;  // of the light, where the view has been dimmed since: of the distance, of the sky

in vec2 over_held;
in vec2 over_sky;
layout(location = 0) out vec4 pixel;

void main() {
    vec4 far = texture(held_distance, over_held);
    vec3 sky = texture(held_sky, over_sky).rgb * kept.y;
    pixel = vec4(far.rgb * kept.x + sky * (1.0 - far.a), 1.0);
}
