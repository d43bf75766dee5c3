// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "synthesis/lsystem/map_lsystem.hpp"

namespace quadrat::commands {

// A grammar of cells to derive: a file that begins with map:, or the name of one that comes along. Other names: none.
// Throws InputError where such a file cannot be read.
bool names_a_map(const std::string& name);
synthesis::lsystem::MapGrammar map_grammar_from(const std::string& name);

// From a first cell that is a regular polygon, as wide as one.
synthesis::lsystem::Map derived_from_polygon(const synthesis::lsystem::MapGrammar& grammar,
                                             const synthesis::lsystem::MapOptions& options, base::Seed seed);

// A line a cell: its corners counter-clockwise, x,y, y up.
std::string text_of_map(const synthesis::lsystem::Map& map);

// Cells in a few tints, and the walls between them.
std::string svg_of_map(const synthesis::lsystem::Map& map, const std::string& name);

}  // namespace quadrat::commands
