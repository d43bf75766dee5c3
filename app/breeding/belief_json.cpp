// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief_json.hpp"

#include <fmt/format.h>

#include <limits>

#include "base/error.hpp"
#include "breeding/belief/coordinates.hpp"
#include "breeding/belief/layered_json.hpp"
#include "breeding/json_vectors.hpp"
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

// {"trees":…,"land":…,"sky":…}, each as `written` writes it.
template <typename Written>
std::string aspects_json(const Written& written) {
    std::string text = "{";
    for (const Aspect aspect : kAspects)
        text += fmt::format(R"({}"{}":{})", text.size() > 1 ? "," : "", name_of(aspect), written(aspect));
    return text + "}";
}

// read(aspect, value, place) for each aspect of an object that root holds under key.
template <typename Read>
void read_aspects(const json& root, std::string_view key, std::string_view source, const Read& read) {
    const json& object = member(root, key, source);
    genome::require_object(object, {"trees", "land", "sky"}, source, key);
    for (const Aspect aspect : kAspects)
        read(aspect, member(object, name_of(aspect), source), fmt::format("{}.{}", key, name_of(aspect)));
}

std::string vectors_json(const genome::PerAspect<std::vector<double>>& vectors) {
    return aspects_json([&](Aspect aspect) { return fmt::format("[{}]", fmt::join(vectors[aspect], ",")); });
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
    wish.evidence = evidence_from(member(value, "evidence", source), source, place);
    return wish;
}

std::string aspect_json(const BeliefState& state, Aspect aspect) {
    if (state.genome == genome::Genome::Full) {
        std::string text = begun_json(state.layered[aspect]);
        if (state.layered[aspect].winner)
            text += fmt::format(R"(,"inherited":"{}")", genome::text_of(state.inherited[aspect]));
        return text + "}";
    }
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

AspectBelief aspect_from(const json& value, std::string_view source, const std::string& place, AspectBelief belief,
                         base::Seed& inherited) {
    genome::require_object(value, {"isotropic", "archetypes", "winner", "shown", "inherited"}, source, place);
    const std::size_t n = belief.isotropic.mean.size();
    belief.isotropic = wish_from(member(value, "isotropic", source), n, source, place + ".isotropic");
    if (belief.near_archetypes)
        belief.near_archetypes = wish_from(member(value, "archetypes", source), n, source, place + ".archetypes");
    read_winner(value, n, source, place, belief, inherited);
    return belief;
}

// As it was kept before there was more than words.
LayeredBelief migrated_from(const json& value, std::string_view source, const std::string& place, Aspect aspect,
                            BeliefState& state) {
    const std::vector<Place> archetypes = archetype_places(state.genome, aspect, state.map);
    AspectBelief blank = initial_belief(dimensions_of(state.genome, aspect), archetypes);
    return migrated(aspect_from(value, source, place, std::move(blank), state.inherited[aspect]), state.map, aspect);
}

void read_aspect(const json& value, std::string_view source, const std::string& place, Aspect aspect,
                 BeliefState& state) {
    if (state.genome == genome::Genome::Classic) {
        state.aspects[aspect] =
            aspect_from(value, source, place, std::move(state.aspects[aspect]), state.inherited[aspect]);
        return;
    }
    if (value.is_object() && value.contains("isotropic")) {
        state.layered[aspect] = migrated_from(value, source, place, aspect, state);
        return;
    }
    state.layered[aspect] =
        layered_from(value, source, place, state.map.atlas(aspect), genome::vocabulary(aspect).size());
    if (state.layered[aspect].winner)
        state.inherited[aspect] = genome::seed_from(member(value, "inherited", source), source, place + ".inherited");
}

// {"tall":…,…}, each axis of an aspect as `written` writes it.
template <typename Written>
std::string axes_json(genome::Genome genome, Aspect aspect, const Written& written) {
    std::string text = "{";
    for (std::size_t i = 0; i < dimensions_of(genome, aspect); ++i) {
        const Axis axis = axis_of(genome, aspect, i);
        text += fmt::format(R"({}"{}":{})", i > 0 ? "," : "", axis.name, written(i, axis));
    }
    return text + "}";
}

std::string words_json(const BeliefState& state, Aspect aspect) {
    const Atlas& atlas = state.map.atlas(aspect);
    const Point mean = expected(atlas, state.layered[aspect]).words;
    const Point deviation = word_deviation(atlas, state.layered[aspect]);
    return axes_json(state.genome, aspect, [&](std::size_t i, const Axis&) {
        return fmt::format(R"({{"mean":{},"deviation":{}}})", mean[i], deviation[i]);
    });
}

std::string by_hand_json(const SliderState& state) {
    std::string text = "{";
    for (const auto& [id, value] : state.by_hand)
        text += fmt::format(R"({}"{}":{})", text.size() > 1 ? "," : "", parameter(id).name, genome::shortest(value));
    return text + "}";
}

std::size_t index_from(const json& value, std::size_t count, std::string_view source, const std::string& place) {
    if (value.is_number_unsigned() && value < count) return value.get<std::size_t>();
    throw base::InputError(
        fmt::format("{}: {} is {}; there are {} sliders, counted from 0", source, place, brief(value), count));
}

// Only those that are named, not the defaults of all others.
std::map<genome::ParameterId, float> by_hand_from(const json& value, std::string_view source) {
    const genome::ParameterValues values = genome::values_from(value, source, "by_hand");
    std::map<genome::ParameterId, float> by_hand;
    for (const auto& [name, number] : value.items()) {
        const genome::ParameterId id = genome::parameter_named(name).value();
        by_hand[id] = values[id];
    }
    return by_hand;
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
    return fmt::format(R"({{"round":{},"locked":{},"mean":{},"deviation":{}}})", state.round, locked_json(state.locked),
                       vectors_json(state.mean),
                       aspects_json([&](Aspect aspect) { return fmt::to_string(state.deviation[aspect]); }));
}

std::string to_json(const BeliefState& state) {
    return fmt::format(R"({{"round":{},"locked":{},"aspects":{}}})", state.round, locked_json(state.locked),
                       aspects_json([&](Aspect aspect) { return aspect_json(state, aspect); }));
}

std::string to_json(const SliderState& state) {
    return fmt::format(R"({{"round":{},"locked":{},"places":{},"chosen":{},"by_hand":{}}})", state.round,
                       locked_json(state.locked), vectors_json(state.places),
                       aspects_json([&](Aspect aspect) { return fmt::to_string(state.chosen[aspect]); }),
                       by_hand_json(state));
}

std::string state_json(const PbilState& state) { return vectors_json(state.probability); }
std::string state_json(const PbilGaussianState& state) { return vectors_json(state.mean); }
std::string state_json(const RandomState& state) { return vectors_json(initial_pbil(state.genome).probability); }

std::string state_json(const BeliefState& state) {
    return aspects_json([&](Aspect aspect) {
        if (state.genome == genome::Genome::Full) return words_json(state, aspect);
        const Place mean = state.aspects[aspect].mean();
        const Place deviation = state.aspects[aspect].deviation();
        return axes_json(state.genome, aspect, [&](std::size_t i, const Axis& axis) {
            return fmt::format(R"({{"mean":{},"deviation":{}}})", axis.low + mean[i] * (axis.high - axis.low),
                               deviation[i] * (axis.high - axis.low));
        });
    });
}

std::string state_json(const SliderState& state) {
    const std::string places = aspects_json([&](Aspect aspect) {
        return axes_json(state.genome, aspect, [&](std::size_t i, const Axis& axis) {
            return fmt::to_string(axis.low + state.places[aspect][i] * (axis.high - axis.low));
        });
    });
    const std::string chosen = aspects_json([&](Aspect aspect) {
        return fmt::format(R"("{}")", axis_of(state.genome, aspect, state.chosen[aspect]).name);
    });
    return fmt::format(R"({},"chosen":{},"by_hand":{}}})", places.substr(0, places.size() - 1), chosen,
                       by_hand_json(state));
}

void read_belief(std::string_view text, std::string_view source, PbilState& state) {
    const json root = genome::parse_json(text, source);
    genome::require_object(root, {"round", "locked", "probability"}, source, "the belief");
    PbilState read = state;
    read.round = round_from(member(root, "round", source), source);
    read.locked = locked_from(member(root, "locked", source), source);
    read_aspects(root, "probability", source, [&](Aspect aspect, const json& value, const std::string& place) {
        read.probability[aspect] = vector_from(value, bit_count(aspect, state.genome), source, place, 0, 1,
                                               "a probability is a number from 0 to 1");
    });
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
    read_aspects(root, "mean", source, [&](Aspect aspect, const json& value, const std::string& place) {
        read.mean[aspect] = shares_from(value, state.mean[aspect].size(), source, place);
    });
    read_aspects(root, "deviation", source, [&](Aspect aspect, const json& value, const std::string& place) {
        read.deviation[aspect] = shares_from(json::array({value}), 1, source, place).front();
    });
    state = read;
}

void read_belief(std::string_view text, std::string_view source, BeliefState& state) {
    const json root = genome::parse_json(text, source);
    genome::require_object(root, {"round", "locked", "aspects"}, source, "the belief");
    BeliefState read = state;
    read.round = round_from(member(root, "round", source), source);
    read.locked = locked_from(member(root, "locked", source), source);
    read_aspects(root, "aspects", source, [&](Aspect aspect, const json& value, const std::string& place) {
        read_aspect(value, source, place, aspect, read);
    });
    state = read;
}

void read_belief(std::string_view text, std::string_view source, SliderState& state) {
    const json root = genome::parse_json(text, source);
    genome::require_object(root, {"round", "locked", "places", "chosen", "by_hand"}, source, "the belief");
    SliderState read = state;
    read.round = round_from(member(root, "round", source), source);
    read.locked = locked_from(member(root, "locked", source), source);
    read_aspects(root, "places", source, [&](Aspect aspect, const json& value, const std::string& place) {
        read.places[aspect] = shares_from(value, state.places[aspect].size(), source, place);
    });
    read_aspects(root, "chosen", source, [&](Aspect aspect, const json& value, const std::string& place) {
        read.chosen[aspect] = index_from(value, state.places[aspect].size(), source, place);
    });
    read.by_hand = by_hand_from(member(root, "by_hand", source), source);
    state = read;
}

}  // namespace quadrat::breeding
