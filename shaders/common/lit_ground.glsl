// SPDX-License-Identifier: Apache-2.0
// Ground without a picture of its own, lit a vertex.
out vec3 shown;

void show_ground(vec3 at_m, vec3 normal, vec3 root_colour) {
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    vec3 light = view.sunlight.rgb * max(dot(normal, view.to_sun.xyz), 0.0) + ambient_on(normal);
    vec4 haze = haze_at(at_m);
    vec3 clear = encode(seen_by_night(root_colour * root_colour) * light) * cloud_light(at_m);
    shown = mix(clear, haze.rgb, haze.a);
}
