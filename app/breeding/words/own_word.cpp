// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/own_word.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "breeding/words/nearest_words.hpp"
#include "breeding/words/ridge.hpp"
#include "genome/json_text.hpp"
#include "genome/values_json.hpp"
#include "genome/words_json.hpp"

namespace quadrat::breeding {
namespace {

using base::InputError;
using genome::Aspect;
using genome::brief;
using genome::member;
using nlohmann::json;

constexpr double kConstantRidge = 1e-9;
constexpr double kSmallestRidge = 0.02;
constexpr double kLargestRidge = 20;
constexpr double kSameSaid = 0.05;  // a deviation below which nothing was told apart

struct Said {
    std::vector<Point> words;
    std::vector<double> values;
};

Point point_of(const genome::Description& words, Aspect aspect) {
    Point point;
    for (const genome::Word& word : genome::vocabulary(aspect)) point.push_back(words[word.id]);
    return point;
}

void require_of_aspect(const genome::PartialDescription& words, Aspect aspect, std::string_view source,
                       const std::string& place) {
    for (const genome::Word& word : genome::vocabulary())
        if (words[static_cast<std::size_t>(word.id)] && word.aspect != aspect)
            throw InputError(fmt::format("{}: {} names {}, which is of the {}, not of the {}", source, place, word.name,
                                         name_of(word.aspect), name_of(aspect)));
}

void append_scene(Said& said, const json& scene, Aspect aspect, const WordMap& map, std::string_view source,
                  const std::string& place) {
    genome::require_object(scene, {"value", "words", "parameters"}, source, place);
    const json& value = member(scene, "value", source);
    if (!value.is_number() || value.get<double>() < -1 || value.get<double>() > 1)
        throw InputError(
            fmt::format("{}: {}.value is {}; it should be a number from -1 to 1", source, place, brief(value)));
    said.values.push_back(value.get<double>());
    if (scene.contains("words") == scene.contains("parameters"))
        throw InputError(fmt::format("{}: {} should have either words or parameters", source, place));
    if (scene.contains("words")) {
        const auto words = genome::partial_words_from(scene["words"], source, place + ".words");
        require_of_aspect(words, aspect, source, place + ".words");
        said.words.push_back(point_of(map.completed(words), aspect));
    } else {
        const auto values = genome::values_from(scene["parameters"], source, place + ".parameters");
        said.words.push_back(point_of(words_of_scene(values, aspect, map), aspect));
    }
}

double deviation_of(const std::vector<double>& values) {
    double sum = 0;
    double squares = 0;
    for (const double value : values) {
        sum += value;
        squares += value * value;
    }
    const auto n = static_cast<double>(values.size());
    return std::sqrt(std::max(0.0, squares / n - sum * sum / n / n));
}

// One ridge for all words: which of them matter is not to be guessed from ten scenes.
RidgeFit fitted(const Said& said) {
    const std::size_t n = said.words.front().size();
    Eigen::MatrixXd design(static_cast<Eigen::Index>(said.words.size()), static_cast<Eigen::Index>(n + 1));
    for (std::size_t i = 0; i < said.words.size(); ++i) {
        for (std::size_t w = 0; w < n; ++w)
            design(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(w)) = said.words[i][w];
        design(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(n)) = 1;
    }
    const RidgeRegression regression(design, std::vector<double>(said.words.size(), 1.0), n);
    RidgeFit best;
    best.gcv = std::numeric_limits<double>::infinity();
    for (double ridge = kSmallestRidge; ridge <= kLargestRidge; ridge *= 2) {
        std::vector<double> ridges(n + 1, ridge);
        ridges[n] = kConstantRidge;
        RidgeFit fit = regression.with_ridges(said.values, ridges);
        if (fit.gcv < best.gcv) best = std::move(fit);
    }
    return best;
}

std::string name_from(const json& root, std::string_view source) {
    const json& name = member(root, "name", source);
    if (!name.is_string() || name.get_ref<const std::string&>().empty())
        throw InputError(fmt::format("{}: name is {}; it should be a text", source, brief(name)));
    if (genome::word_named(name.get_ref<const std::string&>()))
        throw InputError(fmt::format("{}: name is {}, which is a word already", source, brief(name)));
    return name.get<std::string>();
}

Aspect aspect_from(const json& root, std::string_view source) {
    const json& named = member(root, "aspect", source);
    const auto aspect = named.is_string() ? genome::aspect_named(named.get_ref<const std::string&>()) : std::nullopt;
    if (!aspect)
        throw InputError(fmt::format("{}: aspect is {}; an aspect is trees, land or sky", source, brief(named)));
    return *aspect;
}

}  // namespace

Direction OwnWord::at(double value) const {
    Direction asked = direction;
    asked.value = value - constant;
    return asked;
}

OwnWord own_word_from(std::string_view text, std::string_view source, const WordMap& map) {
    const json root = genome::parse_json(text, source);
    genome::require_object(root, {"quadrat", "version", "name", "aspect", "scenes"}, source, "the file");
    if (member(root, "quadrat", source) != "own word" || member(root, "version", source) != 1)
        throw InputError(
            fmt::format(R"({}: should begin {{"quadrat":"own word","version":1,…}}: another kind or version)", source));
    OwnWord own;
    own.name = name_from(root, source);
    own.aspect = aspect_from(root, source);
    const json& scenes = member(root, "scenes", source);
    if (!scenes.is_array() || scenes.size() < OwnWord::kFewestScenes)
        throw InputError(fmt::format("{}: scenes should be a list of at least {}; it has {}", source,
                                     OwnWord::kFewestScenes, scenes.is_array() ? scenes.size() : 0));
    Said said;
    for (std::size_t i = 0; i < scenes.size(); ++i)
        append_scene(said, scenes[i], own.aspect, map, source, fmt::format("scenes[{}]", i));
    own.spread_of_said = deviation_of(said.values);
    if (own.spread_of_said < kSameSaid)
        throw InputError(
            fmt::format("{}: all scenes have about the same value; describe some that are not {}", source, own.name));
    const RidgeFit fit = fitted(said);
    own.direction = {own.aspect, {fit.weights.begin(), fit.weights.end() - 1}, 0};
    own.constant = fit.weights.back();
    own.direction.value = own.constant;
    own.leave_one_out = fit.leave_one_out;
    return own;
}

}  // namespace quadrat::breeding
