// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "synthesis/lsystem/map_lsystem.hpp"

namespace quadrat::tests {

// What is wrong with a map of cells that divided a whole of this area; "" where nothing is: each cell is a closed ring
// of walls and has an area, each wall has a cell on one side or both, Euler's formula holds, areas sum to the whole.
inline std::string map_faults(const synthesis::lsystem::Map& map, float area) {
    std::map<std::uint32_t, int> sides;
    std::set<std::uint32_t> corners;
    double sum = 0;
    for (std::size_t c = 0; c < map.cells.size(); ++c) {
        const auto& cell = map.cells[c];
        if (cell.size() < 3) return fmt::format("cell {} has {} walls", c, cell.size());
        if (!(map.area(c) > 0)) return fmt::format("cell {} has an area of {}", c, map.area(c));
        sum += static_cast<double>(map.area(c));
        for (std::size_t i = 0; i < cell.size(); ++i) {
            const auto& wall = map.walls[cell[i].wall];
            const auto& next = cell[(i + 1) % cell.size()];
            const auto& after = map.walls[next.wall];
            if ((cell[i].is_along ? wall.to : wall.from) != (next.is_along ? after.from : after.to))
                return fmt::format("cell {} is open behind its wall {}", c, i);
            if (++sides[cell[i].wall] > 2) return fmt::format("wall {} has three sides", cell[i].wall);
            corners.insert({wall.from, wall.to});
        }
    }
    const auto euler =
        static_cast<long>(corners.size()) - static_cast<long>(sides.size()) + static_cast<long>(map.cells.size());
    if (euler != 1) return fmt::format("corners less walls and cells are {}", euler);
    if (std::abs(sum - static_cast<double>(area)) > 1.0e-3 * static_cast<double>(area))
        return fmt::format("the cells' areas sum to {} of {}", sum, area);
    return "";
}

}  // namespace quadrat::tests
