// SPDX-License-Identifier: Apache-2.0
#include "genome/offer_json.hpp"

#include <fmt/format.h>

#include <limits>

#include "base/error.hpp"
#include "genome/json_text.hpp"
#include "genome/pick_json.hpp"
#include "genome/values_json.hpp"
#include "genome/words_json.hpp"

namespace quadrat::genome {
namespace {

using nlohmann::json;

BitGenome bits_from(const json& value, std::string_view source, std::string_view place) {
    require_object(value, {"trees", "land", "sky"}, source, place);
    BitGenome genome;
    for (const Aspect aspect : kAspects) {
        const json& text = member(value, name_of(aspect), source);
        const auto bits = text.is_string() ? bits_of(text.get_ref<const std::string&>()) : std::nullopt;
        if (!bits)
            throw base::InputError(fmt::format("{}: {}.{} is {}; it should be a text of 0 and 1", source, place,
                                               name_of(aspect), brief(text)));
        genome[aspect] = *bits;
    }
    return genome;
}

// Every word, or no description at all.
std::optional<Description> description_from(const json& candidate, std::string_view source, const std::string& place) {
    if (!candidate.contains("words")) return std::nullopt;
    return words_from(candidate["words"], source, place);
}

Candidate candidate_from(const json& value, std::string_view source, const std::string& place) {
    require_object(value, {"bits", "seeds", "parameters", "words"}, source, place);
    return {bits_from(member(value, "bits", source), source, place + ".bits"),
            values_from(member(value, "parameters", source), source, place + ".parameters"),
            seeds_from(member(value, "seeds", source), source, place + ".seeds"),
            description_from(value, source, place + ".words")};
}

}  // namespace

std::string bits_json(const BitGenome& bits) {
    return fmt::format(R"({{"trees":"{}","land":"{}","sky":"{}"}})", text_of(bits[Aspect::Trees]),
                       text_of(bits[Aspect::Land]), text_of(bits[Aspect::Sky]));
}

std::string to_json(const Offer& offer) {
    std::string text = fmt::format(R"({{"round":{},"candidates":[)", offer.round);
    for (std::size_t c = 0; c < kCandidates; ++c) {
        const Candidate& candidate = offer.candidates[c];
        text += fmt::format(R"({}{{"bits":{},"seeds":{},"parameters":{})", c == 0 ? "" : ",", bits_json(candidate.bits),
                            seeds_json(candidate.seeds), values_json(candidate.values));
        if (candidate.words) text += fmt::format(R"(,"words":{})", words_json(*candidate.words));
        text += "}";
    }
    return text + "]}";
}

std::string to_json(const Pick& pick) {
    std::string text = "{";
    for (const Aspect aspect : kAspects)
        if (pick[aspect])
            text += fmt::format(R"({}"{}":{})", text.size() > 1 ? "," : "", name_of(aspect), *pick[aspect]);
    return text + "}";
}

Offer offer_from_json(std::string_view text, std::string_view source) {
    const json root = parse_json(text, source);
    require_object(root, {"round", "candidates"}, source, "the offer");
    const json& round = member(root, "round", source);
    if (!round.is_number_unsigned() || round < 1 || round > std::numeric_limits<int>::max())
        throw base::InputError(fmt::format("{}: round is {}; rounds count from 1", source, brief(round)));
    const json& candidates = member(root, "candidates", source);
    if (!candidates.is_array() || candidates.size() != kCandidates)
        throw base::InputError(fmt::format("{}: candidates should be a list of {}", source, kCandidates));
    Offer offer;
    offer.round = round.get<int>();
    for (std::size_t c = 0; c < kCandidates; ++c)
        offer.candidates[c] = candidate_from(candidates[c], source, fmt::format("candidates[{}]", c));
    return offer;
}

Pick pick_from(const json& value, std::string_view source, std::string_view place) {
    require_object(value, {"trees", "land", "sky"}, source, place);
    Pick pick;
    for (const Aspect aspect : kAspects) {
        const auto found = value.find(std::string(name_of(aspect)));
        if (found == value.end()) continue;
        if (!found->is_number_integer() || *found < 0 || *found >= kCandidates)
            throw base::InputError(fmt::format("{}: {}.{} is {}; a candidate is 0, 1, 2 or 3", source, place,
                                               name_of(aspect), brief(*found)));
        pick[aspect] = found->get<std::size_t>();
    }
    return pick;
}

Pick pick_from_json(std::string_view text, std::string_view source) {
    return pick_from(parse_json(text, source), source, "pick");
}

}  // namespace quadrat::genome
