// SPDX-License-Identifier: Apache-2.0
// What the lower clouds leave of the light, 0 to 1. Their density lies in a small picture of its own, without levels: a
// shadow's edge is soft.
layout(binding = 2) uniform sampler2D cloud_shadow;  // r: density

float cloud_light(vec2 over_clouds) { return 1.0 - texture(cloud_shadow, over_clouds).r * view.cloud_place[0].z; }
