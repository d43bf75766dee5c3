// SPDX-License-Identifier: Apache-2.0
#include "commands/curator_entries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/error.hpp"
#include "genome/speech.hpp"

namespace quadrat::commands {
namespace {

constexpr std::string_view kText = "text.";
constexpr std::size_t kLongestText = 160;

std::string aspect_text(const Texts& say, genome::Aspect aspect) {
    return say(fmt::format("aspect.{}", name_of(aspect)));
}

}  // namespace

std::string value_in(const Fields& fields, const std::string& name) {
    const auto found = fields.find(name);
    if (found == fields.end()) return "";
    const std::size_t from = found->second.find_first_not_of(" \t\r\n");
    if (from == std::string::npos) return "";
    return found->second.substr(from, found->second.find_last_not_of(" \t\r\n") - from + 1);
}

std::optional<double> number_in(const Fields& fields, const std::string& name, const std::string& label) {
    const std::string text = value_in(fields, name);
    if (text.empty()) return std::nullopt;
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size())
        throw base::InputError(fmt::format("{}: \"{}\" is no number; write one such as 20 or 0.5", label, text));
    return number;
}

std::vector<desk::Option> language_options() {
    std::vector<desk::Option> options;
    for (const std::string_view code : genome::language_codes())
        options.push_back({std::string(code), genome::language(code).name()});
    return options;
}

Group words_of(genome::Aspect aspect, const std::map<std::string, std::array<double, 2>>& words, const Texts& say) {
    const auto codes = genome::language_codes();
    const std::string code = std::ranges::find(codes, say.code()) != codes.end() ? say.code() : "en";
    Group group{aspect_text(say, aspect), "", {}};
    for (const genome::Word& word : genome::vocabulary(aspect)) {
        const genome::Language& language = genome::language(code);
        Entry entry{Kind::Range, fmt::format("word.{}", word.name),
                    fmt::format("{} … {}", language.end(word.id, false), language.end(word.id, true)), ""};
        if (const auto found = words.find(std::string(word.name)); found != words.end())
            entry.value = fmt::format("{} {}", found->second[0], found->second[1]);
        entry.least = -1;
        entry.most = 1;
        entry.language = code;
        group.entries.push_back(entry);
    }
    return group;
}

Group locks(const std::vector<std::string>& locked, const Texts& say) {
    Group group{say("words.locked"), say("words.locked.hint"), {}};
    for (const genome::Aspect aspect : genome::kAspects) {
        const std::string name(name_of(aspect));
        group.entries.push_back({Kind::Tick, "locked." + name, aspect_text(say, aspect),
                                 std::ranges::find(locked, name) != locked.end() ? "on" : ""});
    }
    return group;
}

std::vector<std::string> locked_in(const Fields& fields) {
    std::vector<std::string> locked;
    for (const genome::Aspect aspect : genome::kAspects)
        if (fields.contains(fmt::format("locked.{}", name_of(aspect)))) locked.emplace_back(name_of(aspect));
    return locked;
}

std::optional<std::array<double, 2>> range_in(const Fields& fields, std::string_view word) {
    const auto low = number_in(fields, fmt::format("word.{}.low", word), std::string(word));
    const auto high = number_in(fields, fmt::format("word.{}.high", word), std::string(word));
    if (!low && !high) return std::nullopt;
    return std::array{low.value_or(-1), high.value_or(1)};
}

std::string spoken_in(const Fields& query, const site::Configuration& now) {
    const std::string code = value_in(query, "in");
    const auto codes = genome::language_codes();
    return std::ranges::find(codes, code) != codes.end() ? code : now.visit.language;
}

Group texts_of(const std::string& code, const std::map<std::string, std::string>& own, const Texts& say) {
    Group group{genome::language(code).name(), say("texts.hint", {std::to_string(kLongestText)}), {}};
    for (const std::string_view key : genome::kPrompts) {
        Entry entry{Kind::Line, fmt::format("{}{}", kText, key), std::string(key), ""};
        if (const auto found = own.find(std::string(key)); found != own.end()) entry.value = found->second;
        entry.standard = genome::prompt(code, key);
        entry.language = code;
        entry.can_be_previewed = true;
        group.entries.push_back(entry);
    }
    return group;
}

std::vector<desk::Option> languages_beside(const std::string& path) {
    std::vector<desk::Option> others;
    for (const desk::Option& language : language_options())
        others.push_back({fmt::format("{}in={}", path, language.value), language.label});
    return others;
}

std::map<std::string, std::string> texts_in(const Fields& form) {
    std::map<std::string, std::string> texts;
    for (const std::string_view key : genome::kPrompts)
        if (std::string words = value_in(form, fmt::format("{}{}", kText, key)); !words.empty())
            texts[std::string(key)] = std::move(words);
    return texts;
}

}  // namespace quadrat::commands
