// SPDX-License-Identifier: Apache-2.0
#include "breeding/growth_seeds.hpp"

namespace quadrat::breeding {

genome::PerAspect<base::Seed> growth_seeds(base::Seed seed, int round, std::size_t candidate) {
    genome::PerAspect<base::Seed> seeds;
    for (const genome::Aspect aspect : genome::kAspects)
        seeds[aspect] = seed.child("growth").child(round).child(name_of(aspect)).child(candidate);
    return seeds;
}

base::Seed draw_seed(base::Seed seed, int round, genome::Aspect aspect, std::size_t candidate) {
    return seed.child("draw").child(round).child(name_of(aspect)).child(candidate);
}

}  // namespace quadrat::breeding
