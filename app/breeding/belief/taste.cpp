// SPDX-License-Identifier: Apache-2.0
#include "breeding/belief/taste.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "breeding/belief/coordinates.hpp"
#include "breeding/belief/four_means.hpp"
#include "genome/json_text.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::brief;
using genome::kAspects;
using genome::member;
using nlohmann::json;

constexpr double kSlow = 4;  // visits a named scene that nobody made: what taste is weighed against
constexpr double kBound = 2;

bool is_allowed(const Blend& blend, const Atlas& atlas, Aspect aspect, const WordRanges& ranges) {
    const auto vocabulary = genome::vocabulary(aspect);
    for (std::size_t w = 0; w < vocabulary.size(); ++w) {
        double word = 0;
        for (std::size_t k = 0; k < blend.of.size(); ++k) word += blend.shares[k] * atlas.named_words[blend.of[k]][w];
        const WordRange& range = ranges[static_cast<std::size_t>(vocabulary[w].id)];
        if (word < static_cast<double>(range.low) || word > static_cast<double>(range.high)) return false;
    }
    return true;
}

}  // namespace

void add(Taste& taste, const WordMap& map, const genome::Candidate& bred, const genome::PerAspect<bool>& judged) {
    for (const Aspect aspect : kAspects) {
        const Atlas& atlas = map.atlas(aspect);
        if (!judged[aspect] || atlas.named.empty()) continue;
        const Place at = place_of(bred.values, genome::Genome::Full, aspect);
        const auto nearest =
            std::ranges::min_element(atlas.named, {}, [&](const Place& place) { return squared_distance(place, at); });
        ++taste.chosen[aspect][atlas.names[static_cast<std::size_t>(nearest - atlas.named.begin())]];
    }
}

double weight_of(const Taste& taste, Aspect aspect, std::string_view name, std::size_t named) {
    double all = 0;
    double own = 0;
    for (const auto& [chosen, count] : taste.chosen[aspect]) {
        all += count;
        if (chosen == name) own = count;
    }
    const double usual = all / static_cast<double>(std::max<std::size_t>(named, 1));
    return std::clamp((own + kSlow) / (usual + kSlow), 1 / kBound, kBound);
}

std::vector<double> blend_weights(const WordMap& map, Aspect aspect, const Taste& taste, const WordRanges& ranges) {
    const Atlas& atlas = map.atlas(aspect);
    std::vector<double> logs;
    for (const std::string& name : atlas.names)
        logs.push_back(base::portable_log(weight_of(taste, aspect, name, atlas.names.size())));
    std::vector<double> weights;
    for (const Blend& blend : atlas.blends) {
        double weight = 0;
        for (std::size_t k = 0; k < blend.of.size(); ++k) weight += blend.shares[k] * logs[blend.of[k]];
        weights.push_back(is_allowed(blend, atlas, aspect, ranges) ? weight : std::min(weight, 0.0));
    }
    if (weights.empty()) return weights;
    const double largest = *std::ranges::max_element(weights);
    for (double& weight : weights) weight -= largest;
    return weights;
}

std::string to_json(const Taste& taste) {
    std::string text = fmt::format(R"({{"quadrat":"taste","version":1,"since":{})", taste.since);
    for (const Aspect aspect : kAspects) {
        std::string counts;
        for (const auto& [name, count] : taste.chosen[aspect])
            counts += fmt::format("{}{}:{}", counts.empty() ? "" : ",",
                                  json(name).dump(-1, ' ', false, json::error_handler_t::replace), count);
        text += fmt::format(",\n\"{}\":{{{}}}", name_of(aspect), counts);
    }
    return text + "}\n";
}

Taste taste_from(std::string_view text, std::string_view source) {
    const json root = genome::parse_json(text, source);
    genome::require_object(root, {"quadrat", "version", "since", "trees", "land", "sky"}, source, "the file");
    if (member(root, "quadrat", source) != "taste" || member(root, "version", source) != 1)
        throw base::InputError(
            fmt::format(R"({}: should begin {{"quadrat":"taste","version":1,…}}: another kind or version)", source));
    Taste taste;
    const json& since = member(root, "since", source);
    if (!since.is_number_unsigned() || since > std::uint64_t{1} << 53U)
        throw base::InputError(fmt::format("{}: since is {}; visits count from 0", source, brief(since)));
    taste.since = since.get<std::int64_t>();
    for (const Aspect aspect : kAspects) {
        const json& counts = member(root, name_of(aspect), source);
        if (!counts.is_object())
            throw base::InputError(fmt::format("{}: {} should be an object of numbers", source, name_of(aspect)));
        for (const auto& [name, count] : counts.items()) {
            if (!count.is_number_unsigned() || count > 1'000'000'000)
                throw base::InputError(fmt::format("{}: {}.{} is {}; it should be a number of visits", source,
                                                   name_of(aspect), name, brief(count)));
            taste.chosen[aspect][name] = count.get<int>();
        }
    }
    return taste;
}

}  // namespace quadrat::breeding
