// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "synthesis/noise/subdivision.hpp"

namespace quadrat::synthesis::land {

// A sample whose height is known: met exactly.
struct FixedPoint {
    int column = 0;
    int row = 0;
    float height = 0;
};
inline constexpr std::size_t kMostFixedPoints = 2000;

struct FieldRequest {
    int size = 513;  // samples a side of the whole, 2 to 8193
    base::Seed seed;
    noise::Window window;  // the part wanted; no columns: the whole
    float features = 4;    // waves of the first octave across the whole
    int octaves = 9;       // 1 to 16
    float gain = 0.5F;     // of each octave to the one before; subdivisions take H = -log2(gain)
    std::vector<FixedPoint> fixed;
};

// A way to make a heightfield; heights about -1 to 1.
struct FieldMethod {
    std::string_view name;  // "diamond-square"
    std::string_view meaning;
    mesh::Field (*make)(const FieldRequest& request);  // ignores fixed; the window's part of the whole, bit for bit
};

std::span<const FieldMethod> field_methods();
const FieldMethod* field_method(std::string_view name);  // none: no such method

// The field, conditioned on the fixed points: the residual at the points is carried into the field as the
// expectation of a fractal that has it there (intrinsic kriging, Matheron 1973, with variogram r^1.5), so that the
// field stays what its method makes of it between them. Any window gives the same bits as the whole. Throws
// base::InputError naming what is out of range: size, window, octaves, gain, features; a fixed point outside, twice, or
// not a number; more than kMostFixedPoints.
mesh::Field make_field(const FieldMethod& method, const FieldRequest& request);

// Fixed points along a polyline, a step or less apart, for ridges and rivers; heights run evenly between its corners.
std::vector<FixedPoint> points_along(std::span<const FixedPoint> polyline, int step);

}  // namespace quadrat::synthesis::land
