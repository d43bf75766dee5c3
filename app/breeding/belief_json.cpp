// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief_json.hpp"

#include <fmt/format.h>

#include <limits>

#include "base/error.hpp"
#include "genome/json_text.hpp"

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

std::vector<double> vector_from(const json& value, std::size_t count, std::string_view source, Aspect aspect) {
    if (!value.is_array() || value.size() != count)
        throw base::InputError(
            fmt::format("{}: probability.{} should be a list of {} numbers", source, name_of(aspect), count));
    std::vector<double> vector;
    for (const json& element : value) {
        if (!element.is_number() || element.get<double>() < 0.0 || element.get<double>() > 1.0)
            throw base::InputError(fmt::format("{}: probability.{} holds {}; a probability is a number from 0 to 1",
                                               source, name_of(aspect), brief(element)));
        vector.push_back(element.get<double>());
    }
    return vector;
}

}  // namespace

std::string to_json(const genome::PerAspect<std::vector<double>>& probability) {
    std::string text = "{";
    for (const Aspect aspect : kAspects)
        text += fmt::format(R"({}"{}":[{}])", text.size() > 1 ? "," : "", name_of(aspect),
                            fmt::join(probability[aspect], ","));
    return text + "}";
}

std::string to_json(const PbilState& state) {
    return fmt::format(R"({{"round":{},"locked":{},"probability":{}}})", state.round, locked_json(state.locked),
                       to_json(state.probability));
}

std::string to_json(const RandomState& state) {
    return fmt::format(R"({{"round":{},"locked":{}}})", state.round, locked_json(state.locked));
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
            vector_from(member(probability, name_of(aspect), source), bit_count(aspect, state.genome), source, aspect);
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

}  // namespace quadrat::breeding
