// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "breeding/belief/wish.hpp"
#include "breeding/words/described_scene.hpp"
#include "genome/offer.hpp"
#include "genome/words.hpp"

namespace quadrat::breeding {

// A wish has words as its axes in the whole table, and parameters as shares of their ranges in the classic genome.

std::size_t dimensions_of(genome::Genome genome, genome::Aspect aspect);

// A coordinate's name, and what it means at 0 and at 1.
struct Axis {
    std::string_view name;
    double low;
    double high;
};
Axis axis_of(genome::Genome genome, genome::Aspect aspect, std::size_t index);

Place place_of(const genome::Description& words, genome::Aspect aspect);
Place place_of(const genome::ParameterValues& values, genome::Genome genome, genome::Aspect aspect);
Place place_of(const genome::Candidate& candidate, genome::Genome genome, genome::Aspect aspect);

// Where the scenes of an aspect that have a name lie, by their values.
std::vector<Place> named_places(std::span<const DescribedScene> scenes, genome::Genome genome, genome::Aspect aspect);

void set_words(genome::Description& words, genome::Aspect aspect, const Place& place);
void set_values(genome::ParameterValues& values, genome::Genome genome, genome::Aspect aspect, const Place& place);

}  // namespace quadrat::breeding
