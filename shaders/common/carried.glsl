// SPDX-License-Identifier: Apache-2.0
// Where water.frag finds its ripples.
out vec4 carried;     // xy, zw: where in the ripples, of both pictures
flat out float turn;  // how much of the second is shown

void carry(vec2 at_m, vec2 current_m_s) {
    // Still water ripples too: by less than a hand's breadth a second, with the wind.
    const float kTurns_per_s = 0.45;
    vec2 a_turn_m = (current_m_s + vec2(0.25, 0.12)) / kTurns_per_s;
    vec2 turns = fract(view.eye_seconds.w * kTurns_per_s + vec2(0.0, 0.5));
    float tiles_per_m = view.scales.x * 11.0;
    // The second larger and turned, lest their tiles show as a grid.
    vec2 second = (at_m - a_turn_m * turns.y) * (0.71 * tiles_per_m);
    carried = vec4((at_m - a_turn_m * turns.x) * tiles_per_m, mat2(0.92, 0.39, -0.39, 0.92) * second + 0.37);
    turn = abs(2.0 * turns.x - 1.0);
}
