// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief/belief_breeder.hpp"

#include <algorithm>
#include <utility>

#include "breeding/belief/companions.hpp"
#include "breeding/belief/coordinates.hpp"
#include "breeding/growth_seeds.hpp"
#include "genome/parameter_rules.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;

constexpr float kRounding = 1e-5F;  // of a word

void keep_in_ranges(Place& place, Aspect aspect, const WordRanges& ranges) {
    const auto vocabulary = genome::vocabulary(aspect);
    for (std::size_t i = 0; i < vocabulary.size(); ++i) {
        const WordRange& range = ranges[static_cast<std::size_t>(vocabulary[i].id)];
        place[i] =
            std::clamp(place[i], (static_cast<double>(range.low) + 1) / 2, (static_cast<double>(range.high) + 1) / 2);
    }
}

void put_classic(genome::Candidate& candidate, const BeliefState& state, Aspect aspect, const Place& place) {
    set_values(candidate.values, state.genome, aspect, place);
}

// A sketch that a curator's ranges do not allow is moved as its words are moved.
void put(genome::Candidate& candidate, const BeliefState& state, Aspect aspect, const Sketch& sketch) {
    Place place;
    for (const double word : sketch.words) place.push_back((word + 1) / 2);
    if (!candidate.words) candidate.words.emplace();
    set_words(*candidate.words, aspect, place);
    Place parameters = sketch.parameters;
    if (Place allowed = place; keep_in_ranges(allowed, aspect, state.ranges), allowed != place) {
        genome::ParameterValues asked;
        state.map.realise(aspect, *candidate.words, asked);
        set_words(*candidate.words, aspect, allowed);
        genome::ParameterValues instead;
        state.map.realise(aspect, *candidate.words, instead);
        const Place from = place_of(asked, state.genome, aspect);
        const Place to = place_of(instead, state.genome, aspect);
        for (std::size_t p = 0; p < parameters.size(); ++p)
            parameters[p] = std::clamp(parameters[p] + to[p] - from[p], 0.0, 1.0);
    }
    set_values(candidate.values, state.genome, aspect, parameters);
    genome::make_consistent(aspect, candidate.values);
}

bool is_allowed(const std::vector<float>& words, Aspect aspect, const WordRanges& ranges) {
    const auto vocabulary = genome::vocabulary(aspect);
    for (std::size_t w = 0; w < words.size(); ++w) {
        const WordRange& range = ranges[static_cast<std::size_t>(vocabulary[w].id)];
        if (words[w] < range.low - kRounding || words[w] > range.high + kRounding) return false;
    }
    return true;
}

// As it was, exactly.
void put(genome::Candidate& candidate, Aspect aspect, const Shown& shown) {
    const auto ids = parameters_of(aspect, genome::Genome::Full);
    for (std::size_t p = 0; p < ids.size(); ++p) candidate.values.set(ids[p], shown.parameters[p]);
    if (!candidate.words) candidate.words.emplace();
    const auto vocabulary = genome::vocabulary(aspect);
    for (std::size_t w = 0; w < vocabulary.size(); ++w) candidate.words->set(vocabulary[w].id, shown.words[w]);
}

Shown shown_of(const genome::Candidate& candidate, Aspect aspect, const Atlas& atlas) {
    Shown shown;
    for (const genome::ParameterId id : atlas.ids) shown.parameters.push_back(candidate.values[id]);
    if (candidate.words)
        for (const genome::Word& word : genome::vocabulary(aspect)) shown.words.push_back((*candidate.words)[word.id]);
    else
        for (const double word : words_at(atlas, place_of(candidate.values, genome::Genome::Full, aspect)))
            shown.words.push_back(static_cast<float>(word));
    return shown;
}

// Which candidates of an aspect grow by the last winner's accidents: all but the one farthest from it.
std::array<bool, genome::kCandidates> inheriting(std::optional<std::size_t> winner, const FourPlaces& four) {
    std::array<bool, genome::kCandidates> inherits{};
    if (!winner) return inherits;
    const auto farthest =
        std::ranges::max_element(four, {}, [&](const Place& place) { return squared_distance(place, four[*winner]); });
    inherits.fill(true);
    inherits[static_cast<std::size_t>(farthest - four.begin())] = farthest == four.begin() + *winner;
    return inherits;
}

void propose_classic(const BeliefState& state, Aspect aspect, base::Seed seed, genome::Offer& offer) {
    const AspectBelief& belief = state.aspects[aspect];
    // Archetypes are asked for as long as nothing was named.
    const auto known = belief.winner ? std::vector<Place>{} : archetype_places(state.genome, aspect, state.map);
    const FourPlaces four = proposed(belief, known, seed);
    const auto inherits = inheriting(belief.winner, four);
    for (std::size_t c = 0; c < genome::kCandidates; ++c) {
        if (inherits[c]) offer.candidates[c].seeds[aspect] = state.inherited[aspect];
        put_classic(offer.candidates[c], state, aspect, four[c]);
    }
}

void propose_layered(const BeliefState& state, Aspect aspect, base::Seed seed, genome::Offer& offer) {
    const LayeredBelief& belief = state.layered[aspect];
    LayeredBelief blank = belief;
    blank.winner.reset();
    const FourSketches four = proposed(state.map.atlas(aspect), state.is_by_chance ? blank : belief, seed);
    FourPlaces places;
    for (std::size_t c = 0; c < places.size(); ++c) places[c] = four[c].parameters;
    const auto inherits = inheriting(belief.winner, places);
    for (std::size_t c = 0; c < genome::kCandidates; ++c) {
        if (inherits[c]) offer.candidates[c].seeds[aspect] = state.inherited[aspect];
        if (c == belief.winner && is_allowed(belief.shown[c].words, aspect, state.ranges))
            put(offer.candidates[c], aspect, belief.shown[c]);
        else
            put(offer.candidates[c], state, aspect, four[c]);
    }
}

std::optional<std::size_t> winner_of(const BeliefState& state, Aspect aspect) {
    return state.genome == genome::Genome::Classic ? state.aspects[aspect].winner : state.layered[aspect].winner;
}

// One landscape of the four is all that was named best, put together: visitors see what their answers make. It stands
// at another button each round, so that nobody who always presses the same one keeps it, and where it stands does not
// depend on what is picked, so that an aspect can grow before the others are judged.
void bring_winners_together(genome::Offer& offer, const BeliefState& state, base::Seed seed) {
    base::RandomStream chance{seed.child("together").child(static_cast<std::uint64_t>(state.round))};
    const std::size_t at = chance.below(genome::kCandidates);
    for (const Aspect aspect : genome::kAspects)
        if (const auto winner = winner_of(state, aspect); winner && *winner != at) exchange(offer, aspect, at, *winner);
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

BeliefState initial_belief(genome::Genome genome, const WordMap& map, const WordRanges& ranges, const Taste& taste) {
    BeliefState state{genome, map, ranges};
    for (const Aspect aspect : genome::kAspects) {
        if (genome == genome::Genome::Classic) {
            state.aspects[aspect] =
                initial_belief(dimensions_of(genome, aspect), archetype_places(genome, aspect, map));
            continue;
        }
        state.layered[aspect] = initial_belief(map.atlas(aspect));
        state.layered[aspect].blends = blend_weights(map, aspect, taste, ranges);
    }
    return state;
}

genome::Offer propose(const BeliefState& state, base::Seed seed) {
    genome::Offer offer;
    offer.round = state.round;
    for (std::size_t c = 0; c < genome::kCandidates; ++c)
        offer.candidates[c].seeds = growth_seeds(seed, state.round, c);
    for (const Aspect aspect : genome::kAspects) {
        const base::Seed draw = draw_seed(seed, state.round, aspect, 0);
        if (state.genome == genome::Genome::Classic)
            propose_classic(state, aspect, draw, offer);
        else
            propose_layered(state, aspect, draw, offer);
    }
    // Later an aspect is what its own picks make of it, whatever was picked of others.
    if (state.round == 1) put_together(offer);
    bring_winners_together(offer, state, seed);
    return offer;
}

namespace {

void learn_classic(BeliefState& state, Aspect aspect, const genome::Offer& offer, std::size_t picked) {
    FourPlaces shown;
    for (std::size_t c = 0; c < shown.size(); ++c) shown[c] = place_of(offer.candidates[c], state.genome, aspect);
    state.aspects[aspect] = learnt(std::move(state.aspects[aspect]), shown, picked);
}

void learn_layered(BeliefState& state, Aspect aspect, const genome::Offer& offer, std::size_t picked) {
    const Atlas& atlas = state.map.atlas(aspect);
    FourShown shown;
    for (std::size_t c = 0; c < shown.size(); ++c) shown[c] = shown_of(offer.candidates[c], aspect, atlas);
    LayeredBelief before = state.layered[aspect];
    state.layered[aspect] = learnt(atlas, std::move(state.layered[aspect]), shown, picked);
    if (!state.is_by_chance) return;
    before.winner = picked;
    before.shown = shown;
    state.layered[aspect] = std::move(before);
}

}  // namespace

BeliefState learn(const BeliefState& state, const genome::Offer& offer, const genome::Pick& pick) {
    BeliefState next = state;
    ++next.round;
    for (const Aspect aspect : genome::kAspects) {
        if (!pick[aspect] || state.locked[aspect]) continue;
        if (state.genome == genome::Genome::Classic)
            learn_classic(next, aspect, offer, *pick[aspect]);
        else
            learn_layered(next, aspect, offer, *pick[aspect]);
        next.inherited[aspect] = offer.candidates[*pick[aspect]].seeds[aspect];
    }
    return next;
}

genome::Candidate wished(const BeliefState& state, const genome::Candidate& otherwise) {
    genome::Candidate candidate = otherwise;
    for (const Aspect aspect : genome::kAspects) {
        if (!winner_of(state, aspect)) continue;
        candidate.seeds[aspect] = state.inherited[aspect];
        if (state.genome == genome::Genome::Classic)
            put_classic(candidate, state, aspect, state.aspects[aspect].mean());
        else
            put(candidate, state, aspect, expected(state.map.atlas(aspect), state.layered[aspect]));
    }
    return candidate;
}

std::vector<float> moved_beside_words(const WordMap& map, const genome::Candidate& before,
                                      const genome::Candidate& now) {
    const genome::ParameterValues asked_before = map(*before.words);
    const genome::ParameterValues asked_now = map(*now.words);
    std::vector<float> moved(genome::parameter_table().size());
    for (const genome::Parameter& p : genome::parameter_table()) {
        const float by_words = asked_now[p.id] - asked_before[p.id];
        moved[static_cast<std::size_t>(p.id)] = (now.values[p.id] - before.values[p.id] - by_words) / (p.max - p.min);
    }
    return moved;
}

}  // namespace quadrat::breeding
