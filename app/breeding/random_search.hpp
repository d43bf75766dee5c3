// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "genome/offer.hpp"

namespace quadrat::breeding {

// The control arm (2003 paper, section 2.1.1): every bit a fair coin, every round; picks teach it nothing.
// A lock is remembered and changes nothing, since nothing moves.
struct RandomState {
    genome::Genome genome = genome::Genome::Classic;
    genome::PerAspect<bool> locked;
    int round = 1;
    friend bool operator==(const RandomState&, const RandomState&) = default;
};

genome::Offer propose(const RandomState& state, base::Seed seed);

}  // namespace quadrat::breeding
