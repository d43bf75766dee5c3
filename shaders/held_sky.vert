#version 310 es
// SPDX-License-Identifier: Apache-2.0
// One triangle over the whole view, behind all else, that shows the sky as it was held some frames ago. What lies in a
// direction there lies in a direction here by a matrix: no vertex needs to follow the dome.
#include "common/whole_picture.glsl"

layout(location = 0) uniform mat3 held_from_view;  // from clip xy and 1 to the held picture's coordinates, times depth

out vec3 over_held;

void main() {
    vec2 clip = 2.0 * corner_of_whole() - 1.0;
    over_held = held_from_view * vec3(clip, 1.0);
    gl_Position = vec4(clip, 1.0, 1.0);
}
