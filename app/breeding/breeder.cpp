// SPDX-License-Identifier: Apache-2.0
#include "breeding/breeder.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "base/error.hpp"
#include "breeding/belief_json.hpp"

namespace quadrat::breeding {
namespace {

constexpr std::array<std::pair<std::string_view, BreederKind>, 6> kNames{{{"belief", BreederKind::Belief},
                                                                          {"chance", BreederKind::Chance},
                                                                          {"pbil", BreederKind::Pbil},
                                                                          {"pbil-gaussian", BreederKind::PbilGaussian},
                                                                          {"random", BreederKind::Random},
                                                                          {"sliders", BreederKind::Sliders}}};

PbilState learnt(const PbilState& state, const genome::Offer& offer, const genome::Pick& pick,
                 const BreederOptions& options, base::Seed seed) {
    return learn(state, offer, pick, options.pbil, seed);
}

template <typename State>
State learnt(const State& state, const genome::Offer& offer, const genome::Pick& pick, const BreederOptions&,
             base::Seed) {
    return learn(state, offer, pick);
}

RandomState learnt(RandomState state, const genome::Offer&, const genome::Pick&, const BreederOptions&, base::Seed) {
    ++state.round;
    return state;
}

// Breeders that only compare know of no wish beside what was named.
template <typename State>
genome::Candidate wish_of(const State&, const genome::Candidate& named_best) {
    return named_best;
}
genome::Candidate wish_of(const BeliefState& state, const genome::Candidate& named_best) {
    return wished(state, named_best);
}
genome::Candidate wish_of(const SliderState& state, const genome::Candidate& named_best) {
    return wished(state, named_best);
}
genome::Candidate wish_of(const PbilGaussianState& state, const genome::Candidate& named_best) {
    return wished(state, named_best);
}

}  // namespace

Breeder::Breeder(const BreederOptions& options) : options_(options) {
    switch (options.kind) {
        case BreederKind::Belief:
            belief_ = initial_belief(options.genome, word_map(), options.ranges, options.taste);
            break;
        case BreederKind::Chance: {
            BeliefState state = initial_belief(options.genome, word_map(), options.ranges, options.taste);
            state.is_by_chance = true;
            belief_ = std::move(state);
            break;
        }
        case BreederKind::Pbil:
            belief_ = initial_pbil(options.genome);
            break;
        case BreederKind::PbilGaussian:
            belief_ = initial_pbil_gaussian(options.genome);
            break;
        case BreederKind::Random:
            belief_ = RandomState{options.genome, {}, 1};
            break;
        case BreederKind::Sliders:
            belief_ = initial_sliders(options.genome, word_map(), options.ranges);
            break;
    }
}

std::string_view Breeder::name() const {
    for (const auto& [name, kind] : kNames)
        if (kind == options_.kind) return name;
    return {};
}

int Breeder::round() const {
    return std::visit([](const auto& belief) { return belief.round; }, belief_);
}

genome::Offer Breeder::propose(base::Seed seed) const {
    return std::visit([seed](const auto& belief) { return breeding::propose(belief, seed); }, belief_);
}

void Breeder::learn(const genome::Offer& offer, const genome::Pick& pick, base::Seed seed) {
    std::visit([&](auto& belief) { belief = learnt(belief, offer, pick, options_, seed); }, belief_);
}

void Breeder::set_lock(genome::Aspect aspect, Lock lock) {
    std::visit([&](auto& belief) { belief.locked[aspect] = lock == Lock::Locked; }, belief_);
}

Lock Breeder::lock(genome::Aspect aspect) const {
    return std::visit([&](const auto& belief) { return belief.locked[aspect] ? Lock::Locked : Lock::Open; }, belief_);
}

genome::Candidate Breeder::wished(const genome::Candidate& named_best) const {
    return std::visit([&](const auto& belief) { return wish_of(belief, named_best); }, belief_);
}

void Breeder::set_range(genome::WordId word, WordRange range) {
    if (auto* belief = std::get_if<BeliefState>(&belief_)) belief->ranges[static_cast<std::size_t>(word)] = range;
    if (auto* sliders = std::get_if<SliderState>(&belief_)) sliders->ranges[static_cast<std::size_t>(word)] = range;
}

SliderState& Breeder::require_sliders(std::string_view source) {
    if (auto* sliders = std::get_if<SliderState>(&belief_)) return *sliders;
    throw base::InputError(fmt::format("{}: the breeder is {}; only sliders can be turned", source, name()));
}

void Breeder::turn(std::string_view name, std::optional<double> value, std::string_view source) {
    SliderState& sliders = require_sliders(source);
    sliders = turned(sliders, name, value, source);
}

void Breeder::choose(std::string_view name, std::string_view source) {
    SliderState& sliders = require_sliders(source);
    sliders = chosen(sliders, name, source);
}

std::size_t Breeder::sliders() const {
    return std::holds_alternative<SliderState>(belief_) ? slider_count(options_.genome) : 0;
}

std::optional<SliderPosition> Breeder::slider(std::size_t number) const {
    const auto* state = std::get_if<SliderState>(&belief_);
    if (state == nullptr) return std::nullopt;
    return breeding::slider(*state, number);
}

void Breeder::slide(std::size_t number, int direction) {
    if (auto* state = std::get_if<SliderState>(&belief_)) *state = slid(*state, number, direction);
}

const BeliefState* Breeder::layered_belief() const {
    const auto* belief = std::get_if<BeliefState>(&belief_);
    const bool is_in_words = belief != nullptr && belief->genome == genome::Genome::Full && !belief->is_by_chance;
    return is_in_words ? belief : nullptr;
}

std::string Breeder::state_json() const {
    return std::visit([](const auto& belief) { return breeding::state_json(belief); }, belief_);
}

std::string Breeder::belief_json() const {
    return std::visit([](const auto& belief) { return to_json(belief); }, belief_);
}

void Breeder::believe(std::string_view belief_json, std::string_view source) {
    std::visit([&](auto& belief) { read_belief(belief_json, source, belief); }, belief_);
}

BreederKind breeder_named(std::string_view name) {
    std::string known;
    for (const auto& [known_name, kind] : kNames) {
        if (name == known_name) return kind;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", known_name);
    }
    throw base::InputError(fmt::format("there is no breeder \"{}\"; there are {}", name, known));
}

}  // namespace quadrat::breeding
