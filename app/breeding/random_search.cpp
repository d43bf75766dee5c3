// SPDX-License-Identifier: Apache-2.0
#include "breeding/random_search.hpp"

#include "breeding/pbil.hpp"

namespace quadrat::breeding {

genome::Offer propose(const RandomState& state, base::Seed seed) {
    PbilState undecided = initial_pbil(state.genome);
    undecided.round = state.round;
    return propose(undecided, seed);
}

}  // namespace quadrat::breeding
