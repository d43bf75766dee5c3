// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "base/seed.hpp"
#include "genome/aspect.hpp"

namespace quadrat::breeding {

// The chance a candidate grows by: keyed by the breeder's seed, the round, the aspect and the candidate.
genome::PerAspect<base::Seed> growth_seeds(base::Seed seed, int round, std::size_t candidate);

// The stream a breeder draws an aspect of a candidate from.
base::Seed draw_seed(base::Seed seed, int round, genome::Aspect aspect, std::size_t candidate);

}  // namespace quadrat::breeding
