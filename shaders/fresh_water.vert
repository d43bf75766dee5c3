#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Lakes and rivers: their own surface, above the sea's.
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/water_surface.glsl"
#include "common/carried.glsl"

layout(location = 0) in vec4 at_m_foam;
layout(location = 1) in vec2 current_m_s;  // east and south

void main() {
    // From afar a stream is seen in scraps between what is before it: they would be white.
    float far = clamp(distance(at_m_foam.xyz, view.eye_seconds.xyz) * 0.006 - 0.6, 0.0, 0.75);
    show_water(at_m_foam.xyz, at_m_foam.w * (1.0 - far));
    carry(at_m_foam.xz, current_m_s);
}
