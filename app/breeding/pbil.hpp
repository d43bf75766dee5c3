// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "base/seed.hpp"
#include "genome/offer.hpp"

namespace quadrat::breeding {

// Population-based incremental learning (Baluja 1994), as "Genetic selection of parametric scenes" (2003), sections
// 2.1.5 and 4, uses it: one probability vector an aspect, updated by the candidate that was named best there.

enum class MutationForm {
    TowardHalf,  // a small step towards 0.5
    Random,      // a weighted average with random numbers
};

struct PbilOptions {
    double learning_rate = 0.2;  // in [0, 1]: the weight of the named candidate's bits
    double mutation = 0.02;      // in [0, 1]: the weight of 0.5, or of chance
    MutationForm mutation_form = MutationForm::TowardHalf;
    friend bool operator==(const PbilOptions&, const PbilOptions&) = default;
};

struct PbilState {
    genome::Genome genome = genome::Genome::Classic;
    genome::PerAspect<std::vector<double>> probability;  // of a 1, a bit; in [0, 1]
    genome::PerAspect<bool> locked;
    int round = 1;
    friend bool operator==(const PbilState&, const PbilState&) = default;
};

PbilState initial_pbil(genome::Genome genome);  // every probability 0.5, nothing locked, round 1

// Four candidates: a bit is 1 where a uniform number in [0, 1) is below its probability. The number is keyed by seed,
// round, aspect, candidate and bit; a candidate's growth seeds by seed, round, aspect and candidate.
genome::Offer propose(const PbilState& state, base::Seed seed);

// The state of the next round. For each aspect that is judged and not locked, with bit b of the named candidate,
//     P  = P (1 - LR) + LR b                                  then, with mutation m,
//     P  = P + m (0.5 - P)        TowardHalf
//     P  = P (1 - m) + m u        Random; u in [0, 1) is keyed by seed, round, aspect and bit
// evaluated in double, left to right, without contraction: the same bits on every machine. An aspect that is locked or
// was not judged keeps its vector exactly: it is not mutated either, so nothing converges by accident (section 4.1).
PbilState learn(const PbilState& state, const genome::Offer& offer, const genome::Pick& pick,
                const PbilOptions& options, base::Seed seed);

}  // namespace quadrat::breeding
