// SPDX-License-Identifier: Apache-2.0
// Baluja, "Population-Based Incremental Learning", CMU-CS-94-163 (1994), as used by "Genetic selection of parametric
// scenes" (2003), sections 2.1.5 and 4. The paper rates no genes: the named candidate is the updating vector.
#include "breeding/pbil.hpp"

#include <cassert>

#include "breeding/growth_seeds.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::kAspects;

genome::Bits draw(const std::vector<double>& probability, base::Seed seed) {
    genome::Bits bits;
    bits.reserve(probability.size());
    for (std::size_t i = 0; i < probability.size(); ++i)
        bits.push_back(base::RandomStream(seed.child(i)).unit() < probability[i] ? 1 : 0);
    return bits;
}

double mutated(double probability, const PbilOptions& options, base::Seed bit_seed) {
    const double m = options.mutation;
    if (options.mutation_form == MutationForm::TowardHalf) return probability + m * (0.5 - probability);
    return probability * (1.0 - m) + m * base::RandomStream(bit_seed).unit();
}

void update(std::vector<double>& probability, const genome::Bits& bits, const PbilOptions& options, base::Seed seed) {
    assert(probability.size() == bits.size());
    const double rate = options.learning_rate;
    for (std::size_t i = 0; i < probability.size(); ++i) {
        const double learnt = probability[i] * (1.0 - rate) + rate * bits[i];
        probability[i] = mutated(learnt, options, seed.child(i));
    }
}

}  // namespace

PbilState initial_pbil(genome::Genome genome) {
    PbilState state;
    state.genome = genome;
    for (const Aspect aspect : kAspects) state.probability[aspect].assign(bit_count(aspect, genome), 0.5);
    return state;
}

genome::Offer propose(const PbilState& state, base::Seed seed) {
    genome::Offer offer;
    offer.round = state.round;
    for (std::size_t c = 0; c < genome::kCandidates; ++c) {
        genome::Candidate& candidate = offer.candidates[c];
        for (const Aspect aspect : kAspects)
            candidate.bits[aspect] = draw(state.probability[aspect], draw_seed(seed, state.round, aspect, c));
        candidate.values = decode(candidate.bits, state.genome);
        candidate.seeds = growth_seeds(seed, state.round, c);
    }
    return offer;
}

PbilState learn(const PbilState& state, const genome::Offer& offer, const genome::Pick& pick,
                const PbilOptions& options, base::Seed seed) {
    PbilState next = state;
    ++next.round;
    for (const Aspect aspect : kAspects) {
        if (!pick[aspect] || state.locked[aspect]) continue;
        const genome::Candidate& named = offer.candidates.at(*pick[aspect]);
        update(next.probability[aspect], named.bits[aspect], options,
               seed.child("mutation").child(state.round).child(name_of(aspect)));
    }
    return next;
}

}  // namespace quadrat::breeding
