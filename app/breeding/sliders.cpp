// SPDX-License-Identifier: Apache-2.0
#include "breeding/sliders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "breeding/belief/coordinates.hpp"
#include "breeding/growth_seeds.hpp"
#include "genome/json_text.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::kAspects;

constexpr double kStep = 0.25;

struct Axle {
    Aspect aspect;
    std::size_t index;
};

std::optional<Axle> axle_named(genome::Genome genome, std::string_view name) {
    for (const Aspect aspect : kAspects)
        for (std::size_t i = 0; i < dimensions_of(genome, aspect); ++i)
            if (axis_of(genome, aspect, i).name == name) return Axle{aspect, i};
    return std::nullopt;
}

Axle axle_of(genome::Genome genome, std::size_t number) {
    for (const Aspect aspect : kAspects) {
        const std::size_t count = dimensions_of(genome, aspect);
        if (number < count) return {aspect, number};
        number -= count;
    }
    return {kAspects.back(), 0};
}

// What a curator allows of a coordinate, from 0 to 1.
std::array<double, 2> allowed(const SliderState& state, const Axle& axle) {
    if (state.genome == genome::Genome::Classic) return {0, 1};
    const WordRange& range = state.ranges[static_cast<std::size_t>(genome::vocabulary(axle.aspect)[axle.index].id)];
    return {(static_cast<double>(range.low) + 1) / 2, (static_cast<double>(range.high) + 1) / 2};
}

void put(genome::Candidate& candidate, const SliderState& state, Aspect aspect, Place place) {
    for (std::size_t i = 0; i < place.size(); ++i) {
        const auto [low, high] = allowed(state, {aspect, i});
        place[i] = std::clamp(place[i], low, high);
    }
    if (state.genome == genome::Genome::Classic) {
        set_values(candidate.values, state.genome, aspect, place);
    } else {
        if (!candidate.words) candidate.words.emplace();
        set_words(*candidate.words, aspect, place);
        state.map.realise(aspect, *candidate.words, candidate.values);
    }
    for (const auto& [id, value] : state.by_hand)
        if (parameter(id).aspect == aspect) candidate.values.set(id, value);
}

void require_open(const SliderState& state, Aspect aspect, std::string_view name, std::string_view source) {
    if (state.locked[aspect])
        throw base::InputError(fmt::format("{}: {} is of the {}, which are locked", source, name, name_of(aspect)));
}

void require_within(double value, double low, double high, std::string_view name, std::string_view source) {
    if (!(value >= low && value <= high))
        throw base::InputError(fmt::format("{}: {} is {}; it should be from {} to {}", source, name,
                                           genome::shortest(value), genome::shortest(low), genome::shortest(high)));
}

void turn_by_hand(SliderState& state, const genome::Parameter& row, std::optional<double> value,
                  std::string_view source) {
    require_open(state, row.aspect, row.name, source);
    if (!value) {
        state.by_hand.erase(row.id);
        return;
    }
    require_within(*value, row.min, row.max, row.name, source);
    state.by_hand[row.id] = static_cast<float>(*value);
}

[[noreturn]] void refuse_unknown(genome::Genome genome, std::string_view name, std::string_view source) {
    throw base::InputError(fmt::format("{}: there is no slider {}; there are the {} of this genome", source,
                                       genome::brief(nlohmann::json(std::string(name))),
                                       genome == genome::Genome::Full ? "words, and the parameters" : "parameters"));
}

}  // namespace

SliderState initial_sliders(genome::Genome genome, const WordMap& map, const WordRanges& ranges) {
    SliderState state{genome, map, ranges, {}};
    for (const Aspect aspect : kAspects)
        for (std::size_t i = 0; i < dimensions_of(genome, aspect); ++i) {
            const auto [low, high] = allowed(state, {aspect, i});
            state.places[aspect].push_back(std::clamp(0.5, low, high));
        }
    return state;
}

genome::Offer propose(const SliderState& state, base::Seed seed) {
    genome::Offer offer;
    offer.round = state.round;
    for (std::size_t c = 0; c < genome::kCandidates; ++c) {
        // The first round's chance for all of them: what is seen to change is what was turned.
        offer.candidates[c].seeds = growth_seeds(seed, 1, 0);
        for (const Aspect aspect : kAspects) {
            Place place = state.places[aspect];
            const auto [low, high] = allowed(state, {aspect, state.chosen[aspect]});
            place[state.chosen[aspect]] =
                low + (high - low) * static_cast<double>(c) / static_cast<double>(genome::kCandidates - 1);
            put(offer.candidates[c], state, aspect, std::move(place));
        }
    }
    return offer;
}

SliderState learn(const SliderState& state, const genome::Offer& offer, const genome::Pick& pick) {
    SliderState next = state;
    ++next.round;
    for (const Aspect aspect : kAspects) {
        if (!pick[aspect] || state.locked[aspect]) continue;
        const std::size_t chosen = state.chosen[aspect];
        next.places[aspect][chosen] = place_of(offer.candidates[*pick[aspect]], state.genome, aspect)[chosen];
        next.chosen[aspect] = (chosen + 1) % next.places[aspect].size();
    }
    return next;
}

genome::Candidate wished(const SliderState& state, const genome::Candidate& otherwise) {
    genome::Candidate candidate = otherwise;
    for (const Aspect aspect : kAspects) put(candidate, state, aspect, state.places[aspect]);
    return candidate;
}

SliderState turned(const SliderState& state, std::string_view name, std::optional<double> value,
                   std::string_view source) {
    SliderState next = state;
    ++next.round;
    const auto axle = axle_named(state.genome, name);
    if (!axle) {
        const auto id = genome::parameter_named(name);
        if (!id || state.genome == genome::Genome::Classic) refuse_unknown(state.genome, name, source);
        turn_by_hand(next, parameter(*id), value, source);
        return next;
    }
    require_open(state, axle->aspect, name, source);
    if (!value) throw base::InputError(fmt::format("{}: {} is null; a slider always stands somewhere", source, name));
    const Axis axis = axis_of(state.genome, axle->aspect, axle->index);
    const auto [low, high] = allowed(state, *axle);
    require_within(*value, axis.low + low * (axis.high - axis.low), axis.low + high * (axis.high - axis.low), name,
                   source);
    next.places[axle->aspect][axle->index] = (*value - axis.low) / (axis.high - axis.low);
    return next;
}

SliderState chosen(const SliderState& state, std::string_view name, std::string_view source) {
    const auto axle = axle_named(state.genome, name);
    if (!axle) refuse_unknown(state.genome, name, source);
    SliderState next = state;
    ++next.round;
    next.chosen[axle->aspect] = axle->index;
    return next;
}

std::size_t slider_count(genome::Genome genome) {
    std::size_t count = 0;
    for (const Aspect aspect : kAspects) count += dimensions_of(genome, aspect);
    return count;
}

SliderPosition slider(const SliderState& state, std::size_t number) {
    const Axle axle = axle_of(state.genome, number);
    SliderPosition position{axle.aspect, axis_of(state.genome, axle.aspect, axle.index).name, std::nullopt,
                            state.places[axle.aspect][axle.index]};
    if (state.genome == genome::Genome::Full) position.word = genome::vocabulary(axle.aspect)[axle.index].id;
    return position;
}

SliderState slid(const SliderState& state, std::size_t number, int direction) {
    const Axle axle = axle_of(state.genome, number);
    SliderState next = state;
    ++next.round;
    if (state.locked[axle.aspect]) return next;
    const auto [low, high] = allowed(state, axle);
    double& share = next.places[axle.aspect][axle.index];
    share = std::clamp(share + kStep * direction, low, high);
    return next;
}

}  // namespace quadrat::breeding
