#version 310 es
// SPDX-License-Identifier: Apache-2.0
// Lakes and rivers: their own surface, above the sea's.
#include "common/view.glsl"
#include "common/haze.glsl"
#include "common/water_surface.glsl"

layout(location = 0) in vec4 at_m_foam;
layout(location = 1) in vec2 current_m_s;  // east and south

out vec4 carried;
flat out float turn;

void main() {
    show_water(at_m_foam.xyz, at_m_foam.w);
    // Still water ripples too: by less than a hand's breadth a second, with the wind.
    const float kTurns_per_s = 0.45;
    vec2 a_turn_m = (current_m_s + vec2(0.25, 0.12)) / kTurns_per_s;
    vec2 turns = fract(view.eye_seconds.w * kTurns_per_s + vec2(0.0, 0.5));
    float tiles_per_m = view.scales.x * 11.0;
    vec2 one = (at_m_foam.xz - a_turn_m * turns.x) * tiles_per_m;
    vec2 other = (at_m_foam.xz - a_turn_m * turns.y) * tiles_per_m + 0.37;
    carried = vec4(one, other);
    turn = abs(2.0 * turns.x - 1.0);
}
