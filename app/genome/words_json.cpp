// SPDX-License-Identifier: Apache-2.0
#include "genome/words_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "base/error.hpp"
#include "genome/json_text.hpp"

namespace quadrat::genome {

std::string words_json(const Description& words) {
    std::string text = "{";
    for (const Word& word : vocabulary())
        text += fmt::format(R"({}"{}":{})", text.size() > 1 ? "," : "", word.name, shortest(words[word.id]));
    return text + "}";
}

PartialDescription partial_words_from(const nlohmann::json& value, std::string_view source, std::string_view place) {
    if (!value.is_object())
        throw base::InputError(fmt::format("{}: {} should be an object of words, each from -1 to 1", source, place));
    PartialDescription words{};
    for (const auto& [name, number] : value.items()) {
        const auto id = word_named(name);
        if (!id) {
            std::vector<std::string_view> known;
            for (const Word& word : vocabulary()) known.push_back(word.name);
            throw base::InputError(fmt::format("{}: {} names the word {}; the words are {}", source, place,
                                               brief(nlohmann::json(name)), fmt::join(known, ", ")));
        }
        if (!number.is_number() || number.get<double>() < -1 || number.get<double>() > 1)
            throw base::InputError(
                fmt::format("{}: {}.{} is {}; a word is a number from -1 to 1", source, place, name, brief(number)));
        words[static_cast<std::size_t>(*id)] = number.get<float>();
    }
    return words;
}

Description words_from(const nlohmann::json& value, std::string_view source, std::string_view place) {
    const PartialDescription read = partial_words_from(value, source, place);
    Description words;
    for (const Word& word : vocabulary()) {
        const auto given = read[static_cast<std::size_t>(word.id)];
        if (!given) throw base::InputError(fmt::format("{}: {} lacks the word {}", source, place, word.name));
        words.set(word.id, *given);
    }
    return words;
}

}  // namespace quadrat::genome
