// SPDX-License-Identifier: Apache-2.0
#include "breeding/breeder.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "breeding/belief_json.hpp"

namespace quadrat::breeding {
namespace {

PbilState learnt(const PbilState& state, const genome::Offer& offer, const genome::Pick& pick,
                 const BreederOptions& options, base::Seed seed) {
    return learn(state, offer, pick, options.pbil, seed);
}

RandomState learnt(RandomState state, const genome::Offer&, const genome::Pick&, const BreederOptions&, base::Seed) {
    ++state.round;
    return state;
}

genome::PerAspect<std::vector<double>> probability_of(const PbilState& state) { return state.probability; }

genome::PerAspect<std::vector<double>> probability_of(const RandomState& state) {
    return initial_pbil(state.genome).probability;
}

}  // namespace

Breeder::Breeder(const BreederOptions& options) : options_(options) {
    if (options.kind == BreederKind::Pbil) {
        belief_ = initial_pbil(options.genome);
    } else {
        belief_ = RandomState{options.genome, {}, 1};
    }
}

std::string_view Breeder::name() const { return options_.kind == BreederKind::Pbil ? "pbil" : "random"; }

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

genome::PerAspect<std::vector<double>> Breeder::probability() const {
    return std::visit([](const auto& belief) { return probability_of(belief); }, belief_);
}

std::string Breeder::belief_json() const {
    return std::visit([](const auto& belief) { return to_json(belief); }, belief_);
}

void Breeder::believe(std::string_view belief_json, std::string_view source) {
    std::visit([&](auto& belief) { read_belief(belief_json, source, belief); }, belief_);
}

BreederKind breeder_named(std::string_view name) {
    if (name == "pbil") return BreederKind::Pbil;
    if (name == "random") return BreederKind::Random;
    throw base::InputError(fmt::format("there is no breeder \"{}\"; there are pbil and random", name));
}

}  // namespace quadrat::breeding
