// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief/aspect_belief.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/portable_math.hpp"

namespace quadrat::breeding {
namespace {

constexpr double kIsotropicPrior = 0.3;  // before any pick: how likely that archetypes tell nothing of the wish
constexpr double kOutward = 1.15;
constexpr double kMorePlausible = 0.8;  // of a squared distance: what was shown stays for so much less
constexpr std::size_t kSamples = 256;

std::vector<Place> samples_of(const AspectBelief& belief, base::Seed seed) {
    const double share = belief.isotropic_share();
    const std::vector<double> isotropic_root = root_of(belief.isotropic);
    const std::vector<double> archetype_root =
        belief.near_archetypes ? root_of(*belief.near_archetypes) : std::vector<double>{};
    std::vector<Place> samples;
    base::RandomStream chance(seed);
    for (std::size_t i = 0; i < kSamples; ++i)
        samples.push_back(chance.unit() < share ? drawn(belief.isotropic, isotropic_root, chance)
                                                : drawn(*belief.near_archetypes, archetype_root, chance));
    return samples;
}

FourPlaces first_four(std::span<const Place> archetypes, base::Seed seed) {
    const auto first = base::RandomStream(seed).below(static_cast<std::uint32_t>(archetypes.size()));
    const auto order = farthest_first(archetypes, first, genome::kCandidates);
    FourPlaces four;
    for (std::size_t k = 0; k < four.size(); ++k) four[k] = archetypes[order[k]];
    return four;
}

std::size_t nearest_but(std::size_t left_out, const FourPlaces& places, const Place& to) {
    std::size_t best = left_out == 0 ? 1 : 0;
    for (std::size_t k = 0; k < places.size(); ++k)
        if (k != left_out && squared_distance(places[k], to) < squared_distance(places[best], to)) best = k;
    return best;
}

// Visitors err, and some press anything: besides the winner, what the belief finds clearly nearer to the wish than what
// would come in its stead stays too. The best of the four then seldom gets worse.
void keep_runner_up(FourPlaces& four, const AspectBelief& belief, const Place& middle) {
    const Place& runner_up = belief.shown[nearest_but(*belief.winner, belief.shown, middle)];
    Place& instead = four[nearest_but(*belief.winner, four, runner_up)];
    if (squared_distance(runner_up, middle) < kMorePlausible * squared_distance(instead, middle)) instead = runner_up;
}

}  // namespace

double AspectBelief::isotropic_share() const {
    if (!near_archetypes) return 1;
    const double odds = kIsotropicPrior / (1 - kIsotropicPrior) *
                        base::portable_exp((isotropic.evidence - near_archetypes->evidence) / 2);
    return odds / (1 + odds);
}

Place AspectBelief::mean() const {
    const double share = isotropic_share();
    Place place = isotropic.mean;
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (near_archetypes) place[i] = share * place[i] + (1 - share) * near_archetypes->mean[i];
        place[i] = std::clamp(place[i], 0.0, 1.0);
    }
    return place;
}

Place AspectBelief::deviation() const {
    const std::size_t n = isotropic.mean.size();
    const double share = isotropic_share();
    const Place middle = mean();
    Place deviation(n);
    for (std::size_t i = 0; i < n; ++i) {
        const auto moment = [&](const Wish& wish) {
            return wish.covariance[i * n + i] + (wish.mean[i] - middle[i]) * (wish.mean[i] - middle[i]);
        };
        const double other = near_archetypes ? moment(*near_archetypes) : 0.0;
        deviation[i] = std::sqrt(share * moment(isotropic) + (1 - share) * other);
    }
    return deviation;
}

AspectBelief initial_belief(std::size_t dimensions, std::span<const Place> archetypes) {
    AspectBelief belief;
    belief.isotropic = isotropic_wish(dimensions);
    if (!archetypes.empty()) belief.near_archetypes = archetype_wish(archetypes);
    return belief;
}

AspectBelief learnt(AspectBelief belief, const FourPlaces& shown, std::size_t picked) {
    belief.isotropic = learnt(std::move(belief.isotropic), shown, picked);
    if (belief.near_archetypes) belief.near_archetypes = learnt(std::move(*belief.near_archetypes), shown, picked);
    belief.winner = picked;
    belief.shown = shown;
    return belief;
}

FourPlaces proposed(const AspectBelief& belief, std::span<const Place> archetypes, base::Seed seed) {
    if (!belief.winner && archetypes.size() >= genome::kCandidates) return first_four(archetypes, seed);
    FourPlaces four = four_means(samples_of(belief, seed));
    const Place middle = belief.mean();
    for (Place& place : four)
        for (std::size_t i = 0; i < place.size(); ++i)
            place[i] = std::clamp(middle[i] + kOutward * (place[i] - middle[i]), 0.0, 1.0);
    if (!belief.winner) return four;
    const Place& stays = belief.shown[*belief.winner];
    const auto near =
        std::ranges::min_element(four, {}, [&](const Place& place) { return squared_distance(place, stays); });
    *near = stays;
    std::swap(*near, four[*belief.winner]);
    keep_runner_up(four, belief, middle);
    return four;
}

}  // namespace quadrat::breeding
