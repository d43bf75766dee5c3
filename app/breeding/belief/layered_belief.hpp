// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "base/seed.hpp"
#include "breeding/belief/four_means.hpp"
#include "breeding/words/atlas.hpp"

namespace quadrat::breeding {

// What a wish has that no blend of named scenes tells, as a Gaussian without correlations along the axes of an atlas.
struct Personal {
    Place mean;
    std::vector<double> variance;
    double evidence = 0;  // log probability of the picks so far
    friend bool operator==(const Personal&, const Personal&) = default;
};

// An aspect as it was shown: parameters in table order and words in vocabulary order, exact.
struct Shown {
    std::vector<float> parameters;
    std::vector<float> words;
    friend bool operator==(const Shown&, const Shown&) = default;
};
using FourShown = std::array<Shown, genome::kCandidates>;

// What is believed of a wish among all parameters of an aspect, on three levels: which named scenes it is a blend of;
// how far it goes from the blend as words go; and how far along the detail axes and the rest. Beside it the doubt
// whether named scenes tell anything: a wish that lies anywhere, weighted by how well both foretold the picks.
struct LayeredBelief {
    std::vector<double> blends;  // log weight of each blend of the atlas; the largest is 0
    Personal near_blends;
    Personal anywhere;                  // from the middle of all ranges
    std::optional<std::size_t> winner;  // of the four last shown, the one that was named best
    FourShown shown;                    // what was last judged; empty before the first pick
    friend bool operator==(const LayeredBelief&, const LayeredBelief&) = default;
};

// An aspect as a breeder thinks of it: parameters as shares of their ranges, and words from -1 to 1.
struct Sketch {
    Place parameters;
    Point words;
};
using FourSketches = std::array<Sketch, genome::kCandidates>;

LayeredBelief initial_belief(const Atlas& atlas);

// How likely it is that the wish lies anywhere; 1 where no scenes are named.
double anywhere_share(const Atlas& atlas, const LayeredBelief& belief);

// The wish as it is expected.
Sketch expected(const Atlas& atlas, const LayeredBelief& belief);

// Standard deviation of each word.
Point word_deviation(const Atlas& atlas, const LayeredBelief& belief);

LayeredBelief learnt(const Atlas& atlas, LayeredBelief belief, const FourShown& shown, std::size_t picked);

// The next four. At first, named scenes far from one another. Then four blends between which a pick tells most, each
// moved along all axes in a pattern in which any two differ along two of three, by as much as the belief is unsure
// there. The last winner is among them, in its place, as nearly as doubles tell.
FourSketches proposed(const Atlas& atlas, const LayeredBelief& belief, base::Seed seed);

}  // namespace quadrat::breeding
