// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/seed.hpp"

// Map L-systems: walls of cells are rewritten, and where two new ones that match sprout into a cell, it divides.
namespace quadrat::synthesis::lsystem {

enum class Course : std::uint8_t { Plain, Along, Against };  // how a wall runs, to the one that it came from

// What becomes of a wall: pieces, and between them sprouts of walls into the cell on its left or its right.
struct MapProduction {
    struct Part {
        char letter = 'A';
        Course course = Course::Plain;
        int side = 0;  // 0 a piece of it; 1 a sprout to the left, -1 to the right
    };
    char predecessor = 'A';
    std::vector<Part> successor;
    int line = 0;
};

struct MapGrammar {
    std::string source;  // what errors name
    std::string name;
    std::vector<MapProduction::Part> start;  // the walls of the first cell, counter-clockwise
    std::vector<MapProduction> productions;  // one a letter at most; others stay as they are
    int steps = 4;
};

// Reads one. Throws InputError "SOURCE:LINE:COLUMN: what is wrong; what would be right".
//
//   map: cells that divide crosswise       the first line that is no comment; # begins a comment
//   steps: 5
//   start: A B A B                          the walls of the first cell
//   A -> B[-A][+A]B                         a sprout to the right, one to the left, and what the wall becomes
//   C -> D>[+E<]C                           > runs as its wall does, < against it; a sprout that runs along leads away
//                                           from its wall. Two sprouts of one letter match where one leads away and the
//                                           other back, or neither says so.
MapGrammar read_map_grammar(std::string_view text, const std::string& source);
bool is_map_grammar(std::string_view text);

struct Map {
    struct Wall {
        char letter = 'A';
        std::uint32_t from = 0;  // corners
        std::uint32_t to = 0;
    };
    struct Side {
        std::uint32_t wall = 0;
        bool is_along = true;  // whether one goes round the cell as the wall runs
    };
    std::vector<glm::vec2> corners;
    std::vector<Wall> walls;
    std::vector<std::vector<Side>> cells;  // each counter-clockwise

    std::vector<glm::vec2> outline(std::size_t cell) const;
    float area(std::size_t cell) const;
};

struct MapOptions {
    int steps = -1;       // fewer than 0: the grammar's
    float chance = 0;     // how far a wall divides off its middle, 0 to 0.8
    float most_area = 0;  // a cell of no more than this stays as it is; 0: all divide
    int pull = 0;         // rounds in which inner walls draw themselves short, as soap's do
    std::size_t most_cells = 20000;
};

// The first cell's corners, counter-clockwise, y up, one a wall of the start: its convex outline stays what it is.
// Throws InputError where there are more cells than are allowed, or twelve times as many walls, or the start has
// another number of walls.
Map derive_map(const MapGrammar& grammar, std::span<const glm::vec2> outline, const MapOptions& options,
               base::Seed seed);

// A regular polygon's corners about (0.5, 0.5), counter-clockwise, its first side below; a square is as wide as one.
std::vector<glm::vec2> regular_outline(std::size_t sides);

// Those that come along; by name.
struct NamedMap {
    std::string_view name;
    std::string_view text;
};
std::span<const NamedMap> map_library();
MapGrammar library_map(std::string_view name);  // Throws InputError where there is none of that name.

}  // namespace quadrat::synthesis::lsystem
