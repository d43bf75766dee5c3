// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "base/seed.hpp"
#include "mesh/field.hpp"
#include "synthesis/land/stream_network.hpp"
#include "synthesis/noise/picture_lattice.hpp"
#include "synthesis/noise/subdivision.hpp"

namespace quadrat::synthesis::land {

// A sample whose height is known: met exactly.
struct FixedPoint {
    int column = 0;
    int row = 0;
    float height = 0;
};
inline constexpr std::size_t kMostFixedPoints = 2000;

// A crest or a bed whose height is known all along: evenly between its corners. Met exactly on every sample it passes
// over; beside a ridge the ground does not rise over it, beside a river it does not fall under it.
struct Line {
    enum class Kind { Ridge, River };
    Kind kind = Kind::Ridge;
    std::vector<FixedPoint> corners;  // two or more; a river's never rise
};
inline constexpr std::size_t kMostCorners = 2000;  // of all lines together

struct FieldRequest {
    int size = 513;  // samples a side of the whole, 2 to 8193
    base::Seed seed;
    noise::Window window;  // the part wanted; no columns: the whole
    float features = 4;    // waves of the first octave across the whole
    int octaves = 9;       // 1 to 16
    float gain = 0.5F;     // of each octave to the one before; subdivisions take H = -log2(gain)
    std::vector<FixedPoint> fixed;
    std::vector<Line> lines;
    std::shared_ptr<const noise::PictureLattice> pictures;  // in place of noise, if any: methods that take them
    std::shared_ptr<const StreamNetwork> streams = {};      // what prepared() made for a window after the other
};

// A way to make a heightfield; heights about -1 to 1.
struct FieldMethod {
    std::string_view name;  // "diamond-square"
    std::string_view meaning;
    mesh::Field (*make)(
        const FieldRequest& request);  // ignores fixed and lines; the window's part of the whole, bit for bit
    bool takes_pictures = false;
};

// The request with what all windows of its field share, made once; methods without it make it for each window.
FieldRequest prepared(const FieldMethod& method, FieldRequest request);

std::span<const FieldMethod> field_methods();
const FieldMethod* field_method(std::string_view name);  // none: no such method

// Throws base::InputError naming what is out of range: size, window, octaves, gain, features; a fixed point or corner
// outside, or not a number; a point that is given twice, or lines that cross, with two heights; a river that rises;
// more than kMostFixedPoints or kMostCorners.
void check(const FieldRequest& request);

// What is known of a field, carried into it as the expectation of a fractal that has it there (conditioning by
// intrinsic kriging, Matheron 1973, with variogram r^1.5), so that the field stays what its method makes of it between.
class Conditions {
  public:
    using Heights = std::function<float(int column, int row)>;

    // The request's fixed points and lines, for a field of the request's size that has these heights without them.
    Conditions(const FieldRequest& request, const Heights& without);
    // Over a part of that field. Any window gives the same bits as the whole.
    void apply(mesh::Field& part, const noise::Window& of) const;

  private:
    struct OnLine {
        FixedPoint at;
        float residual;  // what carrying the fewer points leaves to add here
        float side;      // 1 a ridge, -1 a river
    };
    void carry(mesh::Field& part, const noise::Window& of) const;
    void meet_lines(mesh::Field& part, const noise::Window& of) const;

    int size_;
    int reach_;                       // how far beside a line it is felt, samples
    std::vector<FixedPoint> fixed_;   // met exactly
    std::vector<FixedPoint> points_;  // carried: those and some of each line
    std::vector<double> weights_;     // of each, then the constant
    std::vector<OnLine> on_lines_;
};

// The window of the field, conditioned on the fixed points and lines. Throws as check() does, and where the method
// takes no pictures.
mesh::Field make_field(const FieldMethod& method, const FieldRequest& request);

// Fixed points along a polyline, a step or less apart, for ridges and rivers; heights run evenly between its corners.
std::vector<FixedPoint> points_along(std::span<const FixedPoint> polyline, int step);

}  // namespace quadrat::synthesis::land
