// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief/belief_breeder.hpp"

#include <algorithm>
#include <utility>

#include "breeding/belief/coordinates.hpp"
#include "breeding/growth_seeds.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;

// Accidents stay well under what a word does, or four candidates would differ by chance and not by wish.
constexpr double kLargestAccident = 0.06;  // deviation, of a range

void keep_in_ranges(Place& place, Aspect aspect, const WordRanges& ranges) {
    const auto vocabulary = genome::vocabulary(aspect);
    for (std::size_t i = 0; i < vocabulary.size(); ++i) {
        const WordRange& range = ranges[static_cast<std::size_t>(vocabulary[i].id)];
        place[i] =
            std::clamp(place[i], (static_cast<double>(range.low) + 1) / 2, (static_cast<double>(range.high) + 1) / 2);
    }
}

void put(genome::Candidate& candidate, const BeliefState& state, Aspect aspect, Place place) {
    if (state.genome == genome::Genome::Classic) {
        set_values(candidate.values, state.genome, aspect, place);
        return;
    }
    keep_in_ranges(place, aspect, state.ranges);
    if (!candidate.words) candidate.words.emplace();
    set_words(*candidate.words, aspect, place);
    realise(state.map, aspect, *candidate.words, candidate.seeds[aspect], candidate.values);
}

// Which candidates of an aspect grow by the last winner's accidents: all but the one farthest from it.
std::array<bool, genome::kCandidates> inheriting(const AspectBelief& belief, const FourPlaces& four) {
    std::array<bool, genome::kCandidates> inherits{};
    if (!belief.winner) return inherits;
    const Place& stays = belief.shown[*belief.winner];
    const auto farthest =
        std::ranges::max_element(four, {}, [&](const Place& place) { return squared_distance(place, stays); });
    inherits.fill(true);
    inherits[static_cast<std::size_t>(farthest - four.begin())] = farthest == four.begin() + *belief.winner;
    return inherits;
}

}  // namespace

std::vector<Place> archetype_places(genome::Genome genome, Aspect aspect, const WordMap& map) {
    if (genome == genome::Genome::Classic) return named_places(map.scenes(), genome, aspect);
    std::vector<Place> places;
    for (const DescribedScene& scene : map.scenes())
        if (!scene.name.empty() && scene.aspect == aspect)
            places.push_back(place_of(map.completed(scene.words), aspect));
    return places;
}

void realise(const WordMap& map, Aspect aspect, const genome::Description& words, base::Seed seed,
             genome::ParameterValues& values) {
    map.realise(aspect, words, values);
    const base::Seed accidents = seed.child("accidents");
    for (const genome::ParameterId id : parameters_of(aspect, genome::Genome::Full)) {
        const genome::Parameter& p = parameter(id);
        if (p.unit == genome::kChoice) continue;
        base::RandomStream chance(accidents.child(p.name));
        const double deviation = std::min(kLargestAccident, map.spread(id) / 2);
        const double moved = values[id] + deviation * static_cast<double>(chance.normal()) *
                                              (static_cast<double>(p.max) - static_cast<double>(p.min));
        values.set(id, static_cast<float>(moved));
    }
}

BeliefState initial_belief(genome::Genome genome, const WordMap& map) {
    BeliefState state{genome, map};
    for (const Aspect aspect : genome::kAspects)
        state.aspects[aspect] = initial_belief(dimensions_of(genome, aspect), archetype_places(genome, aspect, map));
    return state;
}

genome::Offer propose(const BeliefState& state, base::Seed seed) {
    genome::Offer offer;
    offer.round = state.round;
    for (std::size_t c = 0; c < genome::kCandidates; ++c)
        offer.candidates[c].seeds = growth_seeds(seed, state.round, c);
    for (const Aspect aspect : genome::kAspects) {
        const AspectBelief& belief = state.aspects[aspect];
        // Archetypes are asked for as long as nothing was named.
        const auto known = belief.winner ? std::vector<Place>{} : archetype_places(state.genome, aspect, state.map);
        const FourPlaces four = proposed(belief, known, draw_seed(seed, state.round, aspect, 0));
        const auto inherits = inheriting(belief, four);
        for (std::size_t c = 0; c < genome::kCandidates; ++c) {
            if (inherits[c]) offer.candidates[c].seeds[aspect] = state.inherited[aspect];
            put(offer.candidates[c], state, aspect, four[c]);
        }
    }
    return offer;
}

BeliefState learn(const BeliefState& state, const genome::Offer& offer, const genome::Pick& pick) {
    BeliefState next = state;
    ++next.round;
    for (const Aspect aspect : genome::kAspects) {
        if (!pick[aspect] || state.locked[aspect]) continue;
        FourPlaces shown;
        for (std::size_t c = 0; c < shown.size(); ++c) shown[c] = place_of(offer.candidates[c], state.genome, aspect);
        next.aspects[aspect] = learnt(std::move(next.aspects[aspect]), shown, *pick[aspect]);
        next.inherited[aspect] = offer.candidates[*pick[aspect]].seeds[aspect];
    }
    return next;
}

genome::Candidate wished(const BeliefState& state, const genome::Candidate& otherwise) {
    genome::Candidate candidate = otherwise;
    for (const Aspect aspect : genome::kAspects) {
        if (!state.aspects[aspect].winner) continue;
        candidate.seeds[aspect] = state.inherited[aspect];
        put(candidate, state, aspect, state.aspects[aspect].mean());
    }
    return candidate;
}

}  // namespace quadrat::breeding
