// SPDX-License-Identifier: Apache-2.0
#pragma once
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
float sample(const Field& field, float column, float row);

}  // namespace quadrat::mesh
