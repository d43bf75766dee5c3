// SPDX-License-Identifier: Apache-2.0
// Light of the sky and from the ground on a surface, without a texture: three colours by where it faces.
vec3 ambient_on(vec3 normal) {
    vec3 toward = normal.y > 0.0 ? view.light_above.rgb : view.light_below.rgb;
    return mix(view.light_around.rgb, toward, abs(normal.y));
}
