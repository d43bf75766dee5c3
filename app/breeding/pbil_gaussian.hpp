// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "breeding/belief/four_means.hpp"
#include "genome/offer.hpp"

namespace quadrat::breeding {

// Continuous population-based incremental learning (Sebag & Ducoulombier 1998): a mean and a deviation a parameter
// instead of a probability a bit. For each judged aspect that is not locked, with x the named candidate and l the mean
// of the others, in shares of the range:
//     mean += rate (x - mean) + push (x - l)        deviation = max(least, shrink · deviation)
struct PbilGaussianState {
    genome::Genome genome = genome::Genome::Classic;
    genome::PerAspect<Place> mean;
    genome::PerAspect<double> deviation;
    genome::PerAspect<bool> locked;
    int round = 1;
    friend bool operator==(const PbilGaussianState&, const PbilGaussianState&) = default;
};

PbilGaussianState initial_pbil_gaussian(genome::Genome genome);  // mean 0.5, the deviation of a uniform number
genome::Offer propose(const PbilGaussianState& state, base::Seed seed);
PbilGaussianState learn(const PbilGaussianState& state, const genome::Offer& offer, const genome::Pick& pick);

// The mean, with the accidents of `otherwise`.
genome::Candidate wished(const PbilGaussianState& state, const genome::Candidate& otherwise);

}  // namespace quadrat::breeding
