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
    show_water(at_m_foam.xyz, at_m_foam.w);
    carry(at_m_foam.xz, current_m_s);
}
