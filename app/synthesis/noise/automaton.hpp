// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "base/seed.hpp"
#include "mesh/field.hpp"

// Cellular automata: each cell's next state follows from its own and its eight neighbours', all at once.
namespace quadrat::synthesis::noise {

// Every cell by next(cells, column, row); what lies outside is the rule's to say.
template <typename State, typename Rule>
mesh::Grid<State> next_generation(const mesh::Grid<State>& cells, const Rule& next) {
    mesh::Grid<State> after(cells.columns, cells.rows);
    for (int row = 0; row < cells.rows; ++row)
        for (int column = 0; column < cells.columns; ++column) after.at(column, row) = next(cells, column, row);
    return after;
}

// How many of the eight about a cell are so; those outside are not.
template <typename State, typename Is>
int neighbours(const mesh::Grid<State>& cells, int column, int row, const Is& is) {
    int count = 0;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if ((dx != 0 || dy != 0) && cells.is_inside(column + dx, row + dy) && is(cells.at(column + dx, row + dy)))
                ++count;
    return count;
}

// Conway's game of life: alive 1, dead 0.
mesh::Grid<std::uint8_t> lived(const mesh::Grid<std::uint8_t>& cells);

// How old a forest is at each place after it has spread, burnt and come back for long: 0 just burnt, 1 as old as trees
// get. fires: how often lightning strikes, 0 never (all is old) to 1.
mesh::Field forest_ages(int side, float fires, base::Seed seed);

}  // namespace quadrat::synthesis::noise
