// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "mesh/field.hpp"

namespace quadrat::synthesis::land {

struct StreamErosion {
    int steps = 8;
    float strength = 1;       // of the cutting: 0 none, 1 valleys that reach well into the heights, 3 worn down
    float deposit = 0.4F;     // share of what a stream carries that it may drop a step where it runs flat
    float fans = 0;           // share of it that it spreads as a fan where it leaves the steep ground
    float spring_m2 = 160;    // drained area from which on there is a stream to cut
    float sea_m = 0;          // base level
    float hillslope = 0.05F;  // creep: how far a step evens the ground between streams, 0 to 0.2
};

// What erosion moved, in cubic metres: worn == laid + carried_off, and the sum of heights is less by carried_off and
// crept_off, to rounding.
struct MovedEarth {
    double worn_m3 = 0;
    double laid_m3 = 0;
    double carried_off_m3 = 0;  // over the border or into the sea
    double crept_off_m3 = 0;    // over the border, by creep; less than 0 where the border stands higher
};

// Streams cut by the area they drain and their fall, solved implicitly from the outlets upward, and lay down part of
// what they carry where the ground runs flat. Deterministic; linear in cells and steps.
MovedEarth erode_by_streams(mesh::Field& height_m, float cell_m, const StreamErosion& how);

// The same from coarse to fine, which costs little and reaches far: hollows are filled and valleys cut on a grid of
// every fourth sample, then of every second, then of all; each grid hands on what it changed, so that the field keeps
// its own detail. how.steps counts those of the coarsest grid. The field has 2^k + 1 samples a side, k at least 4.
void carve_valleys(mesh::Field& height_m, float cell_m, const StreamErosion& how);

// Earth slides where the ground is steeper than its angle of repose, given as rise over run, evening out both ends of
// each slope; the sum of heights is kept to rounding. Returns the steepest slope left between neighbours, rise over
// run.
float slide_to_repose(mesh::Field& height_m, float cell_m, float repose_slope, int passes);

// Takes off burrs, wrinkles and pits: a sample that stands more than threshold_m over what the slopes of all but two of
// its eight sides lead to there, or lies so far below it, becomes the mean of those around it. Slopes, ridges and
// summits are what their sides lead to, and stay.
void remove_burrs(mesh::Field& height_m, float threshold_m, int sweeps);

// The mean over a square of (2 reach + 1) samples a side, in two passes of running sums; at the border of what there
// is.
void smooth(mesh::Field& height_m, int reach);

}  // namespace quadrat::synthesis::land
