// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <vector>

#include "breeding/words/word_map.hpp"
#include "genome/offer.hpp"

namespace quadrat::breeding {

// The index-th point of Halton's sequence in [0, 1) a dimension: however many are taken, no corner is left out and none
// asked twice (Halton 1960; the paper's training set was drawn so too). At most twelve dimensions.
Point halton(std::size_t index, std::size_t dimensions);

// Scenes for a curator to describe, spread evenly over the words of an aspect: what the map makes of Halton's points,
// from the first-th on. Their words are left out, to be said by somebody who looks at them.
std::vector<DescribedScene> scenes_to_describe(const WordMap& map, genome::Aspect aspect, std::size_t first,
                                               std::size_t count);

// A whole landscape for a visitor to describe, made of the index-th point of each aspect's words; no two aspects'
// points lie in step. Its words are those points.
genome::Candidate landscape_to_describe(const WordMap& map, std::size_t index, base::Seed seed);

}  // namespace quadrat::breeding
