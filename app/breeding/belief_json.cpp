// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief_json.hpp"

#include <fmt/format.h>

#include <limits>

#include "base/error.hpp"
#include "breeding/belief/coordinates.hpp"
#include "genome/json_text.hpp"
#include "genome/values_json.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::brief;
using genome::kAspects;
using genome::member;
using nlohmann::json;

std::string locked_json(const genome::PerAspect<bool>& locked) {
    std::string text = "[";
    for (const Aspect aspect : kAspects)
        if (locked[aspect]) text += fmt::format(R"({}"{}")", text.size() > 1 ? "," : "", name_of(aspect));
    return text + "]";
}

int round_from(const json& value, std::string_view source) {
    // One less than the largest int: there is always a next round.
    if (value.is_number_unsigned() && value >= 1 && value < std::numeric_limits<int>::max()) return value.get<int>();
    throw base::InputError(fmt::format("{}: round is {}; rounds count from 1", source, brief(value)));
}

genome::PerAspect<bool> locked_from(const json& value, std::string_view source) {
    if (!value.is_array()) throw base::InputError(fmt::format("{}: locked should be a list of aspects", source));
    genome::PerAspect<bool> locked;
    for (const json& name : value) {
        const auto aspect = name.is_string() ? genome::aspect_named(name.get_ref<const std::string&>()) : std::nullopt;
        if (!aspect)
            throw base::InputError(
                fmt::format("{}: locked names {}; an aspect is trees, land or sky", source, brief(name)));
        locked[*aspect] = true;
    }
    return locked;
}

// `what` says what an element is: "a probability is a number from 0 to 1".
std::vector<double> vector_from(const json& value, std::size_t count, std::string_view source, const std::string& place,
                                double low, double high, std::string_view what) {
    if (!value.is_array() || value.size() != count)
        throw base::InputError(fmt::format("{}: {} should be a list of {} numbers", source, place, count));
    std::vector<double> vector;
    for (const json& element : value) {
        if (!element.is_number() || element.get<double>() < low || element.get<double>() > high)
            throw base::InputError(fmt::format("{}: {} holds {}; {}", source, place, brief(element), what));
        vector.push_back(element.get<double>());
    }
    return vector;
}

std::vector<double> shares_from(const json& value, std::size_t count, std::string_view source,
                                const std::string& place) {
    return vector_from(value, count, source, place, 0, 1, "it should be a number from 0 to 1");
}

std::string vectors_json(const genome::PerAspect<std::vector<double>>& vectors) {
    std::string text = "{";
    for (const Aspect aspect : kAspects)
        text +=
            fmt::format(R"({}"{}":[{}])", text.size() > 1 ? "," : "", name_of(aspect), fmt::join(vectors[aspect], ","));
    return text + "}";
}

std::string wish_json(const Wish& wish) {
    return fmt::format(R"({{"mean":[{}],"covariance":[{}],"evidence":{}}})", fmt::join(wish.mean, ","),
                       fmt::join(wish.covariance, ","), wish.evidence);
}

// A covariance that no picks could have left: not symmetric, or of a variance that is not positive.
bool is_covariance(const std::vector<double>& c, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
        if (!(c[i * n + i] > 0)) return false;
        for (std::size_t j = 0; j < i; ++j)
            if (c[i * n + j] * c[i * n + j] > c[i * n + i] * c[j * n + j] * (1 + 1e-9) + 1e-15) return false;
    }
    return true;
}

Wish wish_from(const json& value, std::size_t n, std::string_view source, const std::string& place) {
    genome::require_object(value, {"mean", "covariance", "evidence"}, source, place);
    Wish wish;
    wish.mean = shares_from(member(value, "mean", source), n, source, place + ".mean");
    wish.covariance = vector_from(member(value, "covariance", source), n * n, source, place + ".covariance", -4, 4,
                                  "a covariance is a number from -4 to 4");
    if (!is_covariance(wish.covariance, n))
        throw base::InputError(fmt::format("{}: {}.covariance is not one of positive variances", source, place));
    const json& evidence = member(value, "evidence", source);
    if (!evidence.is_number() || evidence > 0)
        throw base::InputError(fmt::format("{}: {}.evidence is {}; the logarithm of a probability is at most 0", source,
                                           place, brief(evidence)));
    wish.evidence = evidence.get<double>();
    return wish;
}

std::string aspect_json(const BeliefState& state, Aspect aspect) {
    const AspectBelief& belief = state.aspects[aspect];
    std::string text = fmt::format(R"({{"isotropic":{})", wish_json(belief.isotropic));
    if (belief.near_archetypes) text += fmt::format(R"(,"archetypes":{})", wish_json(*belief.near_archetypes));
    if (belief.winner) {
        std::string shown;
        for (const Place& place : belief.shown)
            shown += fmt::format("{}[{}]", shown.empty() ? "" : ",", fmt::join(place, ","));
        text += fmt::format(R"(,"winner":{},"shown":[{}],"inherited":"{}")", *belief.winner, shown,
                            genome::text_of(state.inherited[aspect]));
    }
    return text + "}";
}

void read_winner(const json& value, std::size_t n, std::string_view source, const std::string& place,
                 AspectBelief& belief, base::Seed& inherited) {
    belief.winner.reset();
    belief.shown = {};
    if (!value.contains("winner")) return;
    const json& winner = value["winner"];
    if (!winner.is_number_unsigned() || winner >= genome::kCandidates)
        throw base::InputError(
            fmt::format("{}: {}.winner is {}; a candidate is 0, 1, 2 or 3", source, place, brief(winner)));
    const json& shown = member(value, "shown", source);
    if (!shown.is_array() || shown.size() != genome::kCandidates)
        throw base::InputError(
            fmt::format("{}: {}.shown should be a list of {} places", source, place, genome::kCandidates));
    for (std::size_t c = 0; c < genome::kCandidates; ++c)
        belief.shown[c] = shares_from(shown[c], n, source, fmt::format("{}.shown[{}]", place, c));
    belief.winner = winner.get<std::size_t>();
    inherited = genome::seed_from(member(value, "inherited", source), source, place + ".inherited");
}

void read_aspect(const json& value, std::string_view source, Aspect aspect, BeliefState& state) {
    const auto place = fmt::format("aspects.{}", name_of(aspect));
    genome::require_object(value, {"isotropic", "archetypes", "winner", "shown", "inherited"}, source, place);
    AspectBelief& belief = state.aspects[aspect];
    const std::size_t n = belief.isotropic.mean.size();
    belief.isotropic = wish_from(member(value, "isotropic", source), n, source, place + ".isotropic");
    if (belief.near_archetypes)
        belief.near_archetypes = wish_from(member(value, "archetypes", source), n, source, place + ".archetypes");
    read_winner(value, n, source, place, belief, state.inherited[aspect]);
}

}  // namespace

std::string to_json(const PbilState& state) {
    return fmt::format(R"({{"round":{},"locked":{},"probability":{}}})", state.round, locked_json(state.locked),
                       vectors_json(state.probability));
}

std::string to_json(const RandomState& state) {
    return fmt::format(R"({{"round":{},"locked":{}}})", state.round, locked_json(state.locked));
}

std::string to_json(const PbilGaussianState& state) {
    return fmt::format(R"({{"round":{},"locked":{},"mean":{},"deviation":{{"trees":{},"land":{},"sky":{}}}}})",
                       state.round, locked_json(state.locked), vectors_json(state.mean), state.deviation[Aspect::Trees],
                       state.deviation[Aspect::Land], state.deviation[Aspect::Sky]);
}

std::string to_json(const BeliefState& state) {
    return fmt::format(R"({{"round":{},"locked":{},"aspects":{{"trees":{},"land":{},"sky":{}}}}})", state.round,
                       locked_json(state.locked), aspect_json(state, Aspect::Trees), aspect_json(state, Aspect::Land),
                       aspect_json(state, Aspect::Sky));
}

std::string state_json(const PbilState& state) { return vectors_json(state.probability); }
std::string state_json(const PbilGaussianState& state) { return vectors_json(state.mean); }
std::string state_json(const RandomState& state) { return vectors_json(initial_pbil(state.genome).probability); }

std::string state_json(const BeliefState& state) {
    std::string text = "{";
    for (const Aspect aspect : kAspects) {
        const Place mean = state.aspects[aspect].mean();
        const Place deviation = state.aspects[aspect].deviation();
        text += fmt::format(R"({}"{}":{{)", text.size() > 1 ? "," : "", name_of(aspect));
        for (std::size_t i = 0; i < mean.size(); ++i) {
            const Axis axis = axis_of(state.genome, aspect, i);
            text += fmt::format(R"({}"{}":{{"mean":{},"deviation":{}}})", i > 0 ? "," : "", axis.name,
                                axis.low + mean[i] * (axis.high - axis.low), deviation[i] * (axis.high - axis.low));
        }
        text += "}";
    }
    return text + "}";
}

void read_belief(std::string_view text, std::string_view source, PbilState& state) {
    const json root = genome::parse_json(text, source);
    genome::require_object(root, {"round", "locked", "probability"}, source, "the belief");
    PbilState read = state;
    read.round = round_from(member(root, "round", source), source);
    read.locked = locked_from(member(root, "locked", source), source);
    const json& probability = member(root, "probability", source);
    genome::require_object(probability, {"trees", "land", "sky"}, source, "probability");
    for (const Aspect aspect : kAspects)
        read.probability[aspect] =
            vector_from(member(probability, name_of(aspect), source), bit_count(aspect, state.genome), source,
                        fmt::format("probability.{}", name_of(aspect)), 0, 1, "a probability is a number from 0 to 1");
    state = read;
}

void read_belief(std::string_view text, std::string_view source, RandomState& state) {
    const json root = genome::parse_json(text, source);
    genome::require_object(root, {"round", "locked"}, source, "the belief");
    RandomState read = state;
    read.round = round_from(member(root, "round", source), source);
    read.locked = locked_from(member(root, "locked", source), source);
    state = read;
}

void read_belief(std::string_view text, std::string_view source, PbilGaussianState& state) {
    const json root = genome::parse_json(text, source);
    genome::require_object(root, {"round", "locked", "mean", "deviation"}, source, "the belief");
    PbilGaussianState read = state;
    read.round = round_from(member(root, "round", source), source);
    read.locked = locked_from(member(root, "locked", source), source);
    const json& mean = member(root, "mean", source);
    const json& deviation = member(root, "deviation", source);
    genome::require_object(mean, {"trees", "land", "sky"}, source, "mean");
    genome::require_object(deviation, {"trees", "land", "sky"}, source, "deviation");
    for (const Aspect aspect : kAspects) {
        read.mean[aspect] = shares_from(member(mean, name_of(aspect), source), state.mean[aspect].size(), source,
                                        fmt::format("mean.{}", name_of(aspect)));
        read.deviation[aspect] = shares_from(json::array({member(deviation, name_of(aspect), source)}), 1, source,
                                             fmt::format("deviation.{}", name_of(aspect)))
                                     .front();
    }
    state = read;
}

void read_belief(std::string_view text, std::string_view source, BeliefState& state) {
    const json root = genome::parse_json(text, source);
    genome::require_object(root, {"round", "locked", "aspects"}, source, "the belief");
    BeliefState read = state;
    read.round = round_from(member(root, "round", source), source);
    read.locked = locked_from(member(root, "locked", source), source);
    const json& aspects = member(root, "aspects", source);
    genome::require_object(aspects, {"trees", "land", "sky"}, source, "aspects");
    for (const Aspect aspect : kAspects) read_aspect(member(aspects, name_of(aspect), source), source, aspect, read);
    state = read;
}

}  // namespace quadrat::breeding
