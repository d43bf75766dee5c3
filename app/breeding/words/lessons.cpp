// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/lessons.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "genome/json_text.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using nlohmann::json;

// Visitors see a landscape for a minute and have four buttons to say it with; archetypes were looked at for long.
constexpr double kTrustInVisitors = 0.25;
constexpr int kVersion = 1;

DescribedScene example_of(const genome::WordAnswer& answer, Aspect aspect) {
    DescribedScene example;
    example.aspect = aspect;
    example.weight = kTrustInVisitors;
    for (const genome::ParameterId id : parameters_of(aspect, genome::Genome::Full))
        example.values.set(id, answer.scene.values[id]);
    if (answer.made_of)
        for (const genome::Word& word : genome::vocabulary(aspect))
            example.words[static_cast<std::size_t>(word.id)] = (*answer.made_of)[word.id];
    return example;
}

std::string described_json(const std::vector<DescribedScene>& scenes) {
    std::vector<std::string> files;
    for (const Aspect aspect : genome::kAspects)
        if (std::ranges::any_of(scenes, [&](const DescribedScene& scene) { return scene.aspect == aspect; }))
            files.push_back(to_json(scenes, aspect));
    return fmt::format("[{}]", fmt::join(files, ","));
}

std::vector<DescribedScene> described_from(const json& root, std::string_view key, std::string_view source) {
    const json& list = genome::member(root, key, source);
    if (!list.is_array()) throw base::InputError(fmt::format("{}: {} should be a list", source, key));
    std::vector<DescribedScene> scenes;
    for (const json& file : list) std::ranges::move(described_scenes_from(file, source), std::back_inserter(scenes));
    std::ranges::stable_sort(scenes, {}, &DescribedScene::aspect);  // as they are written
    return scenes;
}

std::vector<DescribedScene> of_aspect(const std::vector<DescribedScene>& scenes, Aspect aspect) {
    std::vector<DescribedScene> own;
    std::ranges::copy_if(scenes, std::back_inserter(own),
                         [&](const DescribedScene& scene) { return scene.aspect == aspect; });
    return own;
}

Lessons of_aspect(const Lessons& lessons, Aspect aspect) {
    return {of_aspect(lessons.curator, aspect), of_aspect(lessons.visitors, aspect)};
}

void append(Lessons& lessons, const Lessons& more) {
    lessons.curator.insert(lessons.curator.end(), more.curator.begin(), more.curator.end());
    lessons.visitors.insert(lessons.visitors.end(), more.visitors.begin(), more.visitors.end());
}

std::vector<DescribedScene> all_scenes(const Lessons& lessons) {
    std::vector<DescribedScene> scenes = default_scenes();
    scenes.insert(scenes.end(), lessons.curator.begin(), lessons.curator.end());
    scenes.insert(scenes.end(), lessons.visitors.begin(), lessons.visitors.end());
    return scenes;
}

}  // namespace

std::vector<DescribedScene> lessons_from(std::span<const genome::WordAnswer> answers) {
    std::vector<DescribedScene> examples;
    for (const Aspect aspect : genome::kAspects) {
        std::vector<DescribedScene> own;
        const genome::Recipe* scene = nullptr;
        for (const genome::WordAnswer& answer : answers) {
            if (word(answer.word).aspect != aspect) continue;
            if (scene == nullptr || *scene != answer.scene) own.push_back(example_of(answer, aspect));
            scene = &answer.scene;
            own.back().words[static_cast<std::size_t>(answer.word)] = answer.value();
        }
        if (own.size() > kMostVisitorScenes)
            own.erase(own.begin(), own.end() - static_cast<std::ptrdiff_t>(kMostVisitorScenes));
        std::ranges::move(own, std::back_inserter(examples));
    }
    return examples;
}

std::string to_json(const Lessons& lessons) {
    return fmt::format("{{\"quadrat\":\"word map\",\"version\":{},\n\"curator\":{},\n\"visitors\":{}}}\n", kVersion,
                       described_json(lessons.curator), described_json(lessons.visitors));
}

Lessons word_lessons_from(std::string_view text, std::string_view source) {
    const json root = genome::parse_json(text, source);
    if (!root.is_object() || !root.contains("quadrat") || root["quadrat"] != "word map")
        return {described_scenes_from(root, source), {}};
    genome::require_object(root, {"quadrat", "version", "curator", "visitors"}, source, "the file");
    if (const json& version = genome::member(root, "version", source); version != kVersion)
        throw base::InputError(fmt::format("{}: version is {}; this program reads word maps of version {}", source,
                                           genome::brief(version), kVersion));
    return {described_from(root, "curator", source), described_from(root, "visitors", source)};
}

WordMap map_of(const Lessons& lessons) {
    if (lessons == Lessons{}) return default_word_map();
    return WordMap(all_scenes(lessons));
}

Training train(const Lessons& wanted, const Lessons& before, const WordMap& map_before, Worse worse) {
    Training training{wanted, map_of(wanted), remarks_on(all_scenes(wanted))};
    Lessons taken;
    for (const Aspect aspect : genome::kAspects) {
        const Lessons own = of_aspect(wanted, aspect);
        const double now = map_before.leave_one_out(aspect);
        const double then = training.map.leave_one_out(aspect);
        const bool is_worse = own != of_aspect(before, aspect) && then > now;
        // What is to be forgotten is forgotten.
        const bool is_refused = is_worse && worse == Worse::Refuse && own != Lessons{};
        append(taken, is_refused ? of_aspect(before, aspect) : own);
        if (is_worse)
            training.said.push_back(fmt::format(
                "{}: told from the others, a scene would be off by {:.2f} % of a range, and is by {:.2f} %; {}",
                name_of(aspect), 100 * then, 100 * now,
                is_refused ? "what was said of it is not taken, and its map stays" : "taken all the same"));
    }
    if (taken != wanted) {
        training.map = taken == before ? map_before : map_of(taken);
        training.lessons = taken;
    }
    return training;
}

}  // namespace quadrat::breeding
