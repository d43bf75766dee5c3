// SPDX-License-Identifier: Apache-2.0
#include "mesh/cell_sheets.hpp"

namespace quadrat::mesh {
namespace {

constexpr int edge_between(int p, int q) {
    for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < 4; ++k) {
            const int low = corner_of(axis, 0, k);
            const int high = corner_of(axis, 1, k);
            if ((low == p && high == q) || (low == q && high == p)) return 4 * axis + k;
        }
    return -1;
}

// Whether a face has four crossings that all belong to one sheet.
bool is_pinched(const Sheets& sheets, int normal, int side) {
    int sheet = -1;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == normal) continue;
        for (int k = 0; k < 4; ++k) {
            if (((corner_of(axis, 0, k) >> normal) & 1) != side) continue;
            const int s{sheets.of_edge[4 * axis + k]};
            if (s < 0 || (sheet >= 0 && s != sheet)) return false;
            sheet = s;
        }
    }
    return true;
}

Sheets sheets_of(int inside) {
    // Which edges' crossings are joined over a face: union by relabelling.
    std::array<int, 12> label{};
    for (int e = 0; e < 12; ++e) label[e] = e;
    const auto join = [&](int a, int b) {
        const int from = label[a];
        const int to = label[b];
        for (int& l : label)
            if (l == from) l = to;
    };
    const auto is_in = [&](int corner) { return ((inside >> corner) & 1) != 0; };
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            std::array<int, 4> ring{};  // the face's corners in order
            constexpr std::array<int, 4> kAround{0, 1, 3, 2};
            for (int i = 0; i < 4; ++i) ring[i] = corner_of(axis, side, kAround[i]);
            std::array<int, 4> crossed{};
            int crossings = 0;
            for (int i = 0; i < 4; ++i)
                if (is_in(ring[i]) != is_in(ring[(i + 1) % 4]))
                    crossed[crossings++] = edge_between(ring[i], ring[(i + 1) % 4]);
            if (crossings == 2) join(crossed[0], crossed[1]);
            if (crossings != 4) continue;
            for (int i = 0; i < 4; ++i)  // the two edges at an inside corner belong together
                if (is_in(ring[i]))
                    join(edge_between(ring[(i + 3) % 4], ring[i]), edge_between(ring[i], ring[(i + 1) % 4]));
        }
    }
    Sheets sheets;
    sheets.of_edge.fill(-1);
    std::array<std::int8_t, 12> number{};
    number.fill(-1);
    for (int e = 0; e < 12; ++e) {
        const int low = corner_of(e / 4, 0, e % 4);
        const int high = corner_of(e / 4, 1, e % 4);
        if (is_in(low) == is_in(high)) continue;
        if (number[label[e]] < 0) number[label[e]] = sheets.count++;
        sheets.of_edge[e] = number[label[e]];
        sheets.crossed[sheets.crossings++] = static_cast<std::uint8_t>(e);
    }
    for (int normal = 0; normal < 3; ++normal)
        for (int side = 0; side < 2; ++side)
            if (is_pinched(sheets, normal, side))
                sheets.pinched = static_cast<std::uint8_t>(sheets.pinched | (1 << (2 * normal + side)));
    return sheets;
}

}  // namespace

const std::array<Sheets, 256>& sheet_table() {
    static const std::array<Sheets, 256> kTable = [] {
        std::array<Sheets, 256> table{};
        for (int i = 0; i < 256; ++i) table[i] = sheets_of(i);
        return table;
    }();
    return kTable;
}

}  // namespace quadrat::mesh
