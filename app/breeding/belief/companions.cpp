// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief/companions.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

#include "genome/parameter_ids.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::WordId;
using Order = std::array<std::size_t, genome::kCandidates>;

// A pair of words that goes together where their product has the factor's sign.
struct Affinity {
    WordId one, other;
    double factor;
};
constexpr std::array<Affinity, 3> kTreesWithLand{
    {{WordId::tropical, WordId::cold, -1.0}, {WordId::leafy, WordId::green, 0.7}, {WordId::leafy, WordId::wet, 0.3}}};
// Grey land under a grey sky is grey all over: what is barren or cold has the colours and the light of the sky.
constexpr std::array<Affinity, 6> kLandWithSky{{{WordId::cold, WordId::warm, -0.3},
                                                {WordId::wet, WordId::misty, 0.3},
                                                {WordId::green, WordId::misty, 0.5},
                                                {WordId::green, WordId::cloudy, 0.35},
                                                {WordId::cold, WordId::misty, -0.4},
                                                {WordId::cold, WordId::vivid, 0.4}}};

double accord(std::span<const Affinity> affinities, const genome::Description& one, const genome::Description& other) {
    double sum = 0;
    for (const Affinity& a : affinities)
        sum += a.factor * static_cast<double>(one[a.one]) * static_cast<double>(other[a.other]);
    return sum;
}

// Snow falls on cold land: on green it would be seen not to lie.
double snow_on(const genome::Description& land, const genome::ParameterValues& sky) {
    constexpr double kFactor = 3;
    return sky[genome::ParameterId::snowfall_share] > 0 ? kFactor * static_cast<double>(land[WordId::cold]) : 0;
}

// Which of the others goes with each, so that the sum is the greatest; the first of equals.
template <typename Accord>
Order best_order(const Accord& of) {
    Order order;
    std::iota(order.begin(), order.end(), std::size_t{0});
    Order best = order;
    double most = -1e9;
    do {
        double sum = 0;
        for (std::size_t k = 0; k < order.size(); ++k) sum += of(k, order[k]);
        if (sum <= most) continue;
        most = sum;
        best = order;
    } while (std::ranges::next_permutation(order).found);
    return best;
}

void reorder(genome::Offer& offer, Aspect aspect, const Order& order) {
    const genome::Offer before = offer;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const genome::Candidate& from = before.candidates[order[k]];
        genome::Candidate& to = offer.candidates[k];
        for (const genome::Parameter& p : genome::parameter_table())
            if (p.aspect == aspect) to.values.set(p.id, from.values[p.id]);
        if (from.words)
            for (const genome::Word& word : genome::vocabulary(aspect)) to.words->set(word.id, (*from.words)[word.id]);
        to.seeds[aspect] = from.seeds[aspect];
    }
}

}  // namespace

double accord(const genome::Description& words) {
    return accord(kTreesWithLand, words, words) + accord(kLandWithSky, words, words);
}

void put_together(genome::Offer& offer) {
    if (!std::ranges::all_of(offer.candidates, [](const genome::Candidate& c) { return c.words.has_value(); })) return;
    const auto with = [&offer](std::span<const Affinity> affinities) {
        return best_order([&](std::size_t one, std::size_t other) {
            return accord(affinities, *offer.candidates[one].words, *offer.candidates[other].words);
        });
    };
    reorder(offer, Aspect::Land, with(kTreesWithLand));
    reorder(offer, Aspect::Sky, best_order([&](std::size_t land, std::size_t sky) {
                const genome::Description& words = *offer.candidates[land].words;
                return accord(kLandWithSky, words, *offer.candidates[sky].words) +
                       snow_on(words, offer.candidates[sky].values);
            }));
}

void exchange(genome::Offer& offer, Aspect aspect, std::size_t one, std::size_t other) {
    Order order;
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::swap(order[one], order[other]);
    reorder(offer, aspect, order);
}

}  // namespace quadrat::breeding
