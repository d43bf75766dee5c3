// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/described_scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "breeding/words/archetype_texts.hpp"
#include "genome/json_text.hpp"
#include "genome/values_json.hpp"

namespace quadrat::breeding {
namespace {

using base::InputError;
using genome::Aspect;
using genome::brief;
using genome::member;
using nlohmann::json;

genome::ParameterValues parameters_from(const json& value, Aspect aspect, std::string_view source,
                                        std::string_view place) {
    genome::ParameterValues values = genome::values_from(value, source, place);
    for (const auto& [name, number] : value.items()) {
        const auto id = genome::parameter_named(name);
        if (parameter(*id).aspect != aspect)
            throw InputError(fmt::format("{}: {} names {}, which is of the {}, not of the {}", source, place, name,
                                         name_of(parameter(*id).aspect), name_of(aspect)));
    }
    return values;
}

genome::WordId word_from(std::string_view name, Aspect aspect, std::string_view source, std::string_view place) {
    const auto id = genome::word_named(name);
    if (id && word(*id).aspect == aspect) return *id;
    std::vector<std::string_view> known;
    for (const genome::Word& word : genome::vocabulary(aspect)) known.push_back(word.name);
    throw InputError(fmt::format("{}: {} names the word {}; words for the {} are {}", source, place,
                                 brief(json(std::string(name))), name_of(aspect), fmt::join(known, ", ")));
}

genome::PartialDescription words_from(const json& value, Aspect aspect, std::string_view source,
                                      std::string_view place) {
    if (!value.is_object()) throw InputError(fmt::format("{}: {} should be an object of words", source, place));
    genome::PartialDescription words{};
    for (const auto& [name, number] : value.items()) {
        const genome::WordId id = word_from(name, aspect, source, place);
        if (!number.is_number() || number.get<double>() < -1 || number.get<double>() > 1)
            throw InputError(
                fmt::format("{}: {}.{} is {}; a word is a number from -1 to 1", source, place, name, brief(number)));
        words[static_cast<std::size_t>(id)] = number.get<float>();
    }
    return words;
}

double weight_from(const json& scene, std::string_view source, std::string_view place) {
    if (!scene.contains("weight")) return 1;
    const json& weight = scene["weight"];
    if (weight.is_number() && weight.get<double>() > 0 && weight.get<double>() <= 1000) return weight.get<double>();
    throw InputError(
        fmt::format("{}: {}.weight is {}; a weight is more than 0 and at most 1000", source, place, brief(weight)));
}

DescribedScene scene_from(const json& value, Aspect aspect, std::string_view source, const std::string& place) {
    genome::require_object(value, {"name", "weight", "words", "parameters"}, source, place);
    DescribedScene scene;
    if (value.contains("name")) {
        if (!value["name"].is_string()) throw InputError(fmt::format("{}: {}.name should be a text", source, place));
        scene.name = value["name"].get<std::string>();
    }
    scene.aspect = aspect;
    scene.words = words_from(member(value, "words", source), aspect, source, place + ".words");
    scene.values = parameters_from(member(value, "parameters", source), aspect, source, place + ".parameters");
    scene.weight = weight_from(value, source, place);
    return scene;
}

void append_ends(const json& ends, Aspect aspect, std::string_view source, std::vector<DescribedScene>& scenes) {
    if (!ends.is_object()) throw InputError(fmt::format("{}: ends should be an object of words", source));
    for (const auto& [name, pair] : ends.items()) {
        const genome::WordId id = word_from(name, aspect, source, "ends");
        const std::string place = "ends." + name;
        if (!pair.is_array() || pair.size() != 2)
            throw InputError(
                fmt::format("{}: {} should be two objects of parameters, low end and high end", source, place));
        for (std::size_t end = 0; end < 2; ++end) {
            DescribedScene scene;
            scene.aspect = aspect;
            for (const genome::Word& word : genome::vocabulary(aspect))
                scene.words[static_cast<std::size_t>(word.id)] = 0.0F;
            scene.words[static_cast<std::size_t>(id)] = end == 0 ? -1.0F : 1.0F;
            scene.values = parameters_from(pair[end], aspect, source, place);
            scenes.push_back(std::move(scene));
        }
    }
}

std::string words_json(const DescribedScene& scene) {
    std::string text;
    for (const genome::Word& word : genome::vocabulary(scene.aspect))
        if (const auto value = scene.words[static_cast<std::size_t>(word.id)])
            text += fmt::format(R"({}"{}":{})", text.empty() ? "" : ",", word.name, genome::shortest(*value));
    return "{" + text + "}";
}

std::string parameters_json(const DescribedScene& scene) {
    std::string text;
    for (const genome::ParameterId id : parameters_of(scene.aspect, genome::Genome::Full))
        text += fmt::format(R"({}"{}":{})", text.empty() ? "" : ",", parameter(id).name,
                            genome::shortest(scene.values[id]));
    return "{" + text + "}";
}

}  // namespace

std::vector<DescribedScene> described_scenes_from(std::string_view text, std::string_view source) {
    return described_scenes_from(genome::parse_json(text, source), source);
}

std::vector<DescribedScene> described_scenes_from(const json& root, std::string_view source) {
    genome::require_object(root, {"quadrat", "version", "aspect", "scenes", "ends"}, source, "the file");
    if (member(root, "quadrat", source) != "described" || member(root, "version", source) != 1)
        throw InputError(fmt::format(
            R"({}: should begin {{"quadrat":"described","version":1,…}}: another kind or version)", source));
    const json& named = member(root, "aspect", source);
    const auto aspect = named.is_string() ? genome::aspect_named(named.get_ref<const std::string&>()) : std::nullopt;
    if (!aspect)
        throw InputError(fmt::format("{}: aspect is {}; an aspect is trees, land or sky", source, brief(named)));
    const json& list = member(root, "scenes", source);
    if (!list.is_array()) throw InputError(fmt::format("{}: scenes should be a list", source));
    std::vector<DescribedScene> scenes;
    for (std::size_t i = 0; i < list.size(); ++i)
        scenes.push_back(scene_from(list[i], *aspect, source, fmt::format("scenes[{}]", i)));
    if (root.contains("ends")) append_ends(root["ends"], *aspect, source, scenes);
    return scenes;
}

std::string to_json(const std::vector<DescribedScene>& scenes, Aspect aspect) {
    std::string text = fmt::format(R"({{"quadrat":"described","version":1,"aspect":"{}","scenes":[)", name_of(aspect));
    bool is_first = true;
    for (const DescribedScene& scene : scenes) {
        if (scene.aspect != aspect) continue;
        text += fmt::format("{}\n{{\"name\":{},\"weight\":{},\"words\":{},\"parameters\":{}}}", is_first ? "" : ",",
                            json(scene.name).dump(-1, ' ', false, json::error_handler_t::replace),
                            genome::shortest(scene.weight), words_json(scene), parameters_json(scene));
        is_first = false;
    }
    return text + "]}\n";
}

const std::vector<DescribedScene>& default_scenes() {
    static const std::vector<DescribedScene> kScenes = [] {
        std::vector<DescribedScene> scenes;
        for (const base::EmbeddedText& text : archetype_texts())
            std::ranges::move(described_scenes_from(text.text, fmt::format("archetypes/{}.json", text.name)),
                              std::back_inserter(scenes));
        return scenes;
    }();
    return kScenes;
}

const std::vector<DescribedScene>& archetypes(Aspect aspect) {
    static const genome::PerAspect<std::vector<DescribedScene>> kArchetypes = [] {
        genome::PerAspect<std::vector<DescribedScene>> named;
        for (const DescribedScene& scene : default_scenes())
            if (!scene.name.empty()) named[scene.aspect].push_back(scene);
        return named;
    }();
    return kArchetypes[aspect];
}

}  // namespace quadrat::breeding
