// SPDX-License-Identifier: Apache-2.0
#include "commands/wall.hpp"

#include <algorithm>

#include "archive/visit_rows.hpp"
#include "base/error.hpp"
#include "base/log.hpp"
#include "breeding/words/nearest_words.hpp"
#include "breeding/words/word_map.hpp"
#include "genome/scene_code.hpp"

namespace quadrat::commands {
namespace {

nursery::Collection collection_in(const std::filesystem::path& state) {
    nursery::Collection collection;
    try {
        archive::read_state(state, [&](const archive::Connection& connection) {
            collection = nursery::Collection::from_json(archive::remembered(connection, "collection"));
        });
    } catch (const base::InputError& error) {
        base::log::info("the wall: {}", error.what());
    }
    return collection;
}

nursery::Work work_of(const std::string& code) {
    nursery::Work work;
    work.code = code;
    work.recipe = genome::recipe_of_code(code, "attract.favourites");
    genome::Description words;
    for (const genome::Aspect aspect : genome::kAspects)
        words = breeding::words_of_scene(work.recipe.values, aspect, breeding::default_word_map(), words);
    work.words = words;
    return work;
}

}  // namespace

nursery::Wall::Read works_beside(const std::filesystem::path& state, const site::Configuration& settings) {
    return [state, attract = settings.attract] {
        std::vector<nursery::Work> works;
        const nursery::Collection collection = collection_in(state);
        const auto add = [&](const nursery::Work& work) {
            const bool is_there = std::ranges::find(works, work.code, &nursery::Work::code) != works.end();
            const bool is_hidden = std::ranges::find(attract.hidden, work.code) != attract.hidden.end();
            if (!is_there && !is_hidden) works.push_back(work);
        };
        for (const std::string& code : attract.favourites) {
            const nursery::Work* known = collection.find(code);
            add(known != nullptr ? *known : work_of(code));
        }
        for (const genome::Recipe& recipe : collection.ranked()) add(*collection.find(genome::code_of(recipe)));
        return works;
    };
}

}  // namespace quadrat::commands
