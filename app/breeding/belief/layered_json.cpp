// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief/layered_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/error.hpp"
#include "breeding/belief/coordinates.hpp"
#include "breeding/json_vectors.hpp"
#include "genome/json_text.hpp"

namespace quadrat::breeding {
namespace {

using genome::brief;
using genome::member;
using nlohmann::json;

constexpr double kLeastLogWeight = -1e6;
constexpr double kFarthest = 50;  // along an axis; the space of parameters is not as wide

std::string personal_json(const Personal& personal) {
    return fmt::format(R"({{"mean":[{}],"variance":[{}],"evidence":{}}})", fmt::join(personal.mean, ","),
                       fmt::join(personal.variance, ","), personal.evidence);
}

Personal personal_from(const json& value, std::size_t axes, std::string_view source, const std::string& place) {
    genome::require_object(value, {"mean", "variance", "evidence"}, source, place);
    Personal personal;
    personal.mean = vector_from(member(value, "mean", source), axes, source, place + ".mean", -kFarthest, kFarthest,
                                "a mean is a number from -50 to 50");
    personal.variance = vector_from(member(value, "variance", source), axes, source, place + ".variance", 1e-9, 4,
                                    "a variance is more than 0 and at most 4");
    personal.evidence = evidence_from(member(value, "evidence", source), source, place);
    return personal;
}

std::vector<float> in_floats(const std::vector<double>& numbers) {
    std::vector<float> floats;
    for (const double number : numbers) floats.push_back(static_cast<float>(number));
    return floats;
}

Shown shown_from(const json& value, std::string_view source, const std::string& place, const Atlas& atlas,
                 std::size_t words) {
    genome::require_object(value, {"parameters", "words"}, source, place);
    Shown shown;
    shown.parameters = in_floats(vector_from(member(value, "parameters", source), atlas.ids.size(), source,
                                             place + ".parameters", -1e9, 1e9, "it should be a number"));
    for (std::size_t p = 0; p < atlas.ids.size(); ++p) {
        const genome::Parameter& row = parameter(atlas.ids[p]);
        if (shown.parameters[p] < row.min || shown.parameters[p] > row.max)
            throw base::InputError(fmt::format("{}: {}.parameters has {} = {}; its range is {} to {}", source, place,
                                               row.name, shown.parameters[p], row.min, row.max));
    }
    shown.words = in_floats(vector_from(member(value, "words", source), words, source, place + ".words", -1, 1,
                                        "a word is a number from -1 to 1"));
    return shown;
}

// Squared distance in deviations, by the root of the covariance (forward substitution).
double in_deviations(const Wish& wish, const std::vector<double>& root, const Place& place) {
    const std::size_t n = place.size();
    std::vector<double> solved(n);
    double squares = 0;
    for (std::size_t i = 0; i < n; ++i) {
        double sum = place[i] - wish.mean[i];
        for (std::size_t k = 0; k < i; ++k) sum -= root[i * n + k] * solved[k];
        solved[i] = sum / root[i * n + i];
        squares += solved[i] * solved[i];
    }
    return squares;
}

void weigh_by_words(LayeredBelief& belief, const Wish& before, const Wish& after, const Atlas& atlas) {
    const std::vector<double> root_before = root_of(before);
    const std::vector<double> root_after = root_of(after);
    for (std::size_t b = 0; b < belief.blends.size(); ++b) {
        Place words(atlas.middle_words.size(), 0.5);
        const Blend& blend = atlas.blends[b];
        for (std::size_t k = 0; k < blend.of.size(); ++k)
            for (std::size_t w = 0; w < words.size(); ++w)
                words[w] += blend.shares[k] * atlas.named_words[blend.of[k]][w] / 2;
        belief.blends[b] = (in_deviations(before, root_before, words) - in_deviations(after, root_after, words)) / 2;
    }
    if (belief.blends.empty()) return;
    const double largest = *std::ranges::max_element(belief.blends);
    for (double& one : belief.blends) one -= largest;
}

}  // namespace

std::string begun_json(const LayeredBelief& belief) {
    std::string text = fmt::format(R"({{"blends":[{}],"near":{},"anywhere":{})", fmt::join(belief.blends, ","),
                                   personal_json(belief.near_blends), personal_json(belief.anywhere));
    if (!belief.winner) return text;
    std::string shown;
    for (const Shown& one : belief.shown)
        shown += fmt::format(R"({}{{"parameters":[{}],"words":[{}]}})", shown.empty() ? "" : ",",
                             fmt::join(one.parameters, ","), fmt::join(one.words, ","));
    return text + fmt::format(R"(,"winner":{},"shown":[{}])", *belief.winner, shown);
}

LayeredBelief layered_from(const json& value, std::string_view source, const std::string& place, const Atlas& atlas,
                           std::size_t words) {
    genome::require_object(value, {"blends", "near", "anywhere", "winner", "shown", "inherited"}, source, place);
    LayeredBelief belief;
    belief.blends = vector_from(member(value, "blends", source), atlas.blends.size(), source, place + ".blends",
                                kLeastLogWeight, 0, "the logarithm of a weight is at most 0");
    belief.near_blends = personal_from(member(value, "near", source), atlas.axes.size(), source, place + ".near");
    belief.anywhere = personal_from(member(value, "anywhere", source), atlas.axes.size(), source, place + ".anywhere");
    if (!value.contains("winner")) return belief;
    const json& winner = value["winner"];
    if (!winner.is_number_unsigned() || winner >= genome::kCandidates)
        throw base::InputError(
            fmt::format("{}: {}.winner is {}; a candidate is 0, 1, 2 or 3", source, place, brief(winner)));
    belief.winner = winner.get<std::size_t>();
    const json& shown = member(value, "shown", source);
    if (!shown.is_array() || shown.size() != genome::kCandidates)
        throw base::InputError(
            fmt::format("{}: {}.shown should be a list of {} candidates", source, place, genome::kCandidates));
    for (std::size_t c = 0; c < genome::kCandidates; ++c)
        belief.shown[c] = shown_from(shown[c], source, fmt::format("{}.shown[{}]", place, c), atlas, words);
    return belief;
}

LayeredBelief migrated(const AspectBelief& in_words, const WordMap& map, genome::Aspect aspect) {
    const Atlas& atlas = map.atlas(aspect);
    LayeredBelief belief = initial_belief(atlas);
    if (in_words.near_archetypes) {
        std::vector<Place> named;
        for (const Point& words : atlas.named_words) {
            Place& place = named.emplace_back();
            for (const double word : words) place.push_back((word + 1) / 2);
        }
        if (!named.empty()) weigh_by_words(belief, archetype_wish(named), *in_words.near_archetypes, atlas);
        belief.near_blends.evidence = in_words.near_archetypes->evidence;
        belief.anywhere.evidence = in_words.isotropic.evidence;
    }
    belief.winner = in_words.winner;
    if (!in_words.winner) return belief;
    for (std::size_t c = 0; c < genome::kCandidates; ++c) {
        genome::Description words;
        set_words(words, aspect, in_words.shown[c]);
        genome::ParameterValues values;
        map.realise(aspect, words, values);
        for (const genome::ParameterId id : atlas.ids) belief.shown[c].parameters.push_back(values[id]);
        for (const genome::Word& word : genome::vocabulary(aspect)) belief.shown[c].words.push_back(words[word.id]);
    }
    return belief;
}

}  // namespace quadrat::breeding
