// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>

// How a surface passes through a cell of eight samples, for all 256 ways of their being inside or outside, from one
// rule: where a face has two inside corners across from each other, they are apart on it. Both cells at a face follow
// the same rule, so there is no crack.
namespace quadrat::mesh {

// Corner c lies at (c & 1, c >> 1 & 1, c >> 2). Edge 4 a + k runs along axis a; k's bits are its place on the two other
// axes, in the order a + 1, a + 2.
constexpr int corner_of(int axis, int along, int k) {
    const int b = (axis + 1) % 3;
    const int c = (axis + 2) % 3;
    return (along << axis) | ((k & 1) << b) | ((k >> 1) << c);
}

// The parts of the surface within one cell.
struct Sheets {
    std::array<std::int8_t, 12> of_edge;  // which sheet crosses the edge; -1: none
    std::int8_t count = 0;
    std::uint8_t pinched = 0;  // bit 2 axis + side: that face has four crossings, all of one sheet
    std::int8_t crossings = 0;
    std::array<std::uint8_t, 12> crossed;  // the edges that are
};

// The corner at which each edge begins.
inline constexpr std::array<int, 12> kLow = [] {
    std::array<int, 12> low{};
    for (int e = 0; e < 12; ++e) low[e] = corner_of(e / 4, 0, e % 4);
    return low;
}();

// By the corners inside, a bit each.
const std::array<Sheets, 256>& sheet_table();

}  // namespace quadrat::mesh
