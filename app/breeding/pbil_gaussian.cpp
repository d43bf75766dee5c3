// SPDX-License-Identifier: Apache-2.0
#include "breeding/pbil_gaussian.hpp"

#include <algorithm>

#include "breeding/belief/coordinates.hpp"
#include "breeding/growth_seeds.hpp"

namespace quadrat::breeding {
namespace {

constexpr double kRate = 0.25;
constexpr double kPush = 0.1;
constexpr double kShrink = 0.92;
constexpr double kLeastDeviation = 0.04;
constexpr double kFirstDeviation = 0.28867513459481287;

}  // namespace

PbilGaussianState initial_pbil_gaussian(genome::Genome genome) {
    PbilGaussianState state;
    state.genome = genome;
    for (const genome::Aspect aspect : genome::kAspects) {
        state.mean[aspect].assign(parameters_of(aspect, genome).size(), 0.5);
        state.deviation[aspect] = kFirstDeviation;
    }
    return state;
}

genome::Offer propose(const PbilGaussianState& state, base::Seed seed) {
    genome::Offer offer;
    offer.round = state.round;
    for (std::size_t c = 0; c < genome::kCandidates; ++c) {
        offer.candidates[c].seeds = growth_seeds(seed, state.round, c);
        for (const genome::Aspect aspect : genome::kAspects) {
            base::RandomStream chance(draw_seed(seed, state.round, aspect, c));
            Place place = state.mean[aspect];
            for (double& x : place)
                x = std::clamp(x + state.deviation[aspect] * static_cast<double>(chance.normal()), 0.0, 1.0);
            set_values(offer.candidates[c].values, state.genome, aspect, place);
        }
    }
    return offer;
}

PbilGaussianState learn(const PbilGaussianState& state, const genome::Offer& offer, const genome::Pick& pick) {
    PbilGaussianState next = state;
    ++next.round;
    for (const genome::Aspect aspect : genome::kAspects) {
        if (!pick[aspect] || state.locked[aspect]) continue;
        Place named = place_of(offer.candidates.at(*pick[aspect]).values, state.genome, aspect);
        Place others(named.size(), 0.0);
        for (std::size_t c = 0; c < genome::kCandidates; ++c) {
            if (c == *pick[aspect]) continue;
            const Place place = place_of(offer.candidates[c].values, state.genome, aspect);
            for (std::size_t i = 0; i < place.size(); ++i) others[i] += place[i] / (genome::kCandidates - 1);
        }
        for (std::size_t i = 0; i < named.size(); ++i) {
            double& mean = next.mean[aspect][i];
            mean = std::clamp(mean + kRate * (named[i] - mean) + kPush * (named[i] - others[i]), 0.0, 1.0);
        }
        next.deviation[aspect] = std::max(kLeastDeviation, kShrink * state.deviation[aspect]);
    }
    return next;
}

genome::Candidate wished(const PbilGaussianState& state, const genome::Candidate& otherwise) {
    genome::Candidate candidate = otherwise;
    for (const genome::Aspect aspect : genome::kAspects)
        set_values(candidate.values, state.genome, aspect, state.mean[aspect]);
    return candidate;
}

}  // namespace quadrat::breeding
