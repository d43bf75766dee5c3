// SPDX-License-Identifier: Apache-2.0
// The land's square at a vertex of its grid.
layout(location = 0) in vec2 column_row;
layout(location = 1) in float height_m;
layout(location = 0) uniform vec2 grid;  // x: cell, m; y: column of the middle

out vec2 over_land;
out vec3 veil;    // shown, of the air before the ground
out float clear;  // what the air leaves of the ground's picture: factor
out vec2 over_clouds;

// Returns where the vertex is.
vec3 show_land() {
    vec2 xz = (column_row - grid.y) * grid.x;
    vec3 at_m = vec3(xz.x, height_m, xz.y);
    gl_Position = view.clip_from_world * vec4(at_m, 1.0);
    over_land = xz * view.scales.x + 0.5;
    vec4 haze = haze_at(at_m);
    veil = haze.rgb * haze.a;
    clear = view.sunlight.w * (1.0 - haze.a);
    over_clouds = under_clouds(at_m);
    return at_m;
}
