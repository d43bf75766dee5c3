// SPDX-License-Identifier: Apache-2.0
// Light of the sky and from the ground on a surface, without a texture.
vec3 ambient_on(vec3 normal) {
    vec4 n = vec4(normal, 1.0);
    return max(vec3(dot(view.ambient[0], n), dot(view.ambient[1], n), dot(view.ambient[2], n)), 0.0);
}
