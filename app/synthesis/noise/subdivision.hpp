// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "mesh/field.hpp"

namespace quadrat::synthesis::noise {

// Terrain by repeated subdivision with ever smaller displacements.
enum class Scheme {
    TriangleEdge,   // Fournier, Fussell & Carpenter 1982: the midpoints of a triangle's sides
    DiamondSquare,  // the same paper: centres of squares, then of diamonds
    SquareSquare,   // Miller 1986: quarter points by 9:3:3:1
    BinSplit,       // Chen & Shi 2011: the midpoint of the longest side alone, two new triangles
};

// A part of a field, in its samples.
struct Window {
    int column = 0;
    int row = 0;
    int columns = 0;
    int rows = 0;
};

struct Subdivision {
    Scheme scheme = Scheme::DiamondSquare;
    int size = 513;      // samples a side of the whole, 2 to 8193; made on the next 2^k + 1
    float hurst = 0.8F;  // H: displacements fall by 2^-H a level; 0 rough to 1 smooth
};

// The window's part of the whole, the same bits as when the whole is made: each displacement hangs on the seed, the
// level and the place alone. Mean 0, deviation in the order of 1. Asserts that the window lies inside.
mesh::Field subdivide(const Subdivision& how, const Window& window, base::Seed seed);

}  // namespace quadrat::synthesis::noise
