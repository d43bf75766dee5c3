// SPDX-License-Identifier: Apache-2.0
// The land's square at a vertex of its grid.
#include "common/grid.glsl"

out vec2 over_land;
out vec3 veil;    // shown, of the air before the ground
out float clear;  // what air and clouds leave of the ground's picture: factor

// Returns where the vertex is.
vec3 show_land() {
    vec3 at_m = grid_place();
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    over_land = at_m.xz * view.scales.x + 0.5;
    vec4 haze = haze_at(at_m);
    veil = haze.rgb * haze.a;
    clear = view.sunlight.w * (1.0 - haze.a) * cloud_light(at_m);
    return at_m;
}
