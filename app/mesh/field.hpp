// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadrat::mesh {

// A rectangle of samples, row by row. Owns them.
template <typename Sample>
struct Grid {
    int columns = 0;
    int rows = 0;
    std::vector<Sample> samples;

    Grid() = default;
    Grid(int columns_, int rows_, Sample fill = {})
        : columns(columns_),
          rows(rows_),
          samples(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), fill) {}

    Sample& at(int column, int row) { return samples[index(column, row)]; }
    const Sample& at(int column, int row) const { return samples[index(column, row)]; }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
    bool is_inside(int column, int row) const { return column >= 0 && row >= 0 && column < columns && row < rows; }
    friend bool operator==(const Grid&, const Grid&) = default;
};

using Field = Grid<float>;

// Bilinear, in sample coordinates; outside: the nearest edge. An empty field gives 0.
template <typename Number>
float sample(const Grid<Number>& field, float column, float row) {
    if (field.samples.empty()) return 0.0F;
    const auto at = [&field](int c, int r) { return static_cast<float>(field.at(c, r)); };
    const float x = std::clamp(column, 0.0F, static_cast<float>(field.columns - 1));
    const float y = std::clamp(row, 0.0F, static_cast<float>(field.rows - 1));
    const int x0 = static_cast<int>(x);
    const int y0 = static_cast<int>(y);
    const int x1 = std::min(x0 + 1, field.columns - 1);
    const int y1 = std::min(y0 + 1, field.rows - 1);
    const float tx = x - static_cast<float>(x0);
    const float ty = y - static_cast<float>(y0);
    const float above = at(x0, y0) + tx * (at(x1, y0) - at(x0, y0));
    const float below = at(x0, y1) + tx * (at(x1, y1) - at(x0, y1));
    return above + ty * (below - above);
}

}  // namespace quadrat::mesh
