// SPDX-License-Identifier: Apache-2.0
// A sample of a heightfield (render/passes/grid.hpp). Before the blocks' next coarser level leaves it out it has moved
// onto that level's triangle, by its own distance from the eye: blocks that share it agree.
layout(location = 1) in vec2 heights;  // its own, and on the coarser level
layout(location = 5) in float error;   // at least 1
layout(location = 0) uniform vec4 grid;  // x: cell, m; y: columns; z: lowest height, m; w: the heights' range, m
// x: for each metre from the eye over its error; y: before it begins; z: 1 over the columns; w: column of the middle
layout(location = 2) uniform vec4 ease;

vec3 grid_place() {
    float number = float(gl_VertexID);
    float row = floor((number + 0.5) * ease.z);  // far from a whole number, so that rounding does no harm
    vec2 xz = (vec2(number - row * grid.y, row) - ease.w) * grid.x;
    vec2 own_coarser = heights * grid.w + grid.z;
    vec3 at_m = vec3(xz.x, own_coarser.x, xz.y);
    float eased = clamp(distance(at_m, view.eye_seconds.xyz) * ease.x / error - ease.y, 0.0, 1.0);
    at_m.y = mix(own_coarser.x, own_coarser.y, eased);
    return at_m;
}
