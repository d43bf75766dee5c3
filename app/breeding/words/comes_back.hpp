// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "breeding/words/word_map.hpp"

namespace quadrat::breeding {

// How far around each place, in words, a scene that was described there is heard: half of the way to its neighbours, so
// that none is drowned where they stand dense, and all of the space between them is covered.
std::vector<double> hearing_of(std::span<const Point> places);

// How a described scene comes back in its own words.
struct ComesBack {
    double radius = 0;  // within which it is heard, see hearing_of()
    double error = 0;   // root mean square over the aspect's parameters, in ranges
    genome::ParameterId worst{};
    double worst_error = 0;  // in ranges; a kind is right (0) or another (1)
};

// A line for each of the map's scenes, in their order.
std::vector<ComesBack> how_scenes_come_back(const WordMap& map);

}  // namespace quadrat::breeding
