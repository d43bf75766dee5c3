// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "base/seed.hpp"
#include "genome/aspect.hpp"
#include "genome/bit_genome.hpp"
#include "genome/parameter_table.hpp"
#include "genome/words.hpp"

namespace quadrat::genome {

inline constexpr std::size_t kCandidates = 4;

// One of the four landscapes of a round. The seeds name the chance that growing may use, an aspect at a time, so that
// an aspect that is inherited whole looks the same again.
struct Candidate {
    BitGenome bits;  // empty in genomes that are not bred as bits
    ParameterValues values;
    PerAspect<base::Seed> seeds;
    std::optional<Description> words;  // nothing in genomes that are not bred in words
    friend bool operator==(const Candidate&, const Candidate&) = default;
};

struct Offer {
    int round = 1;  // 1, 2, …
    std::array<Candidate, kCandidates> candidates;
    friend bool operator==(const Offer&, const Offer&) = default;
};

// Which candidate has the best trees, land, sky: 0 to 3, or nothing where the aspect was not judged.
using Pick = PerAspect<std::optional<std::size_t>>;

}  // namespace quadrat::genome
