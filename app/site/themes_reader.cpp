// SPDX-License-Identifier: Apache-2.0
#include "site/themes_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/error.hpp"
#include "genome/speech.hpp"
#include "site/configuration_checks.hpp"

namespace quadrat::site {
namespace {

using Reader = ConfigurationReader;

void read_range(Reader& reader, const toml::node& node, const std::string& name, std::array<double, 2>& range) {
    const toml::array* ends = node.as_array();
    const auto end = [&](std::size_t i) {
        return ends != nullptr && ends->size() == 2 && (*ends)[i].is_number() ? (*ends)[i].value<double>()
                                                                              : std::nullopt;
    };
    const auto low = end(0), high = end(1);
    if (low && high && -1 <= *low && *low <= *high && *high <= 1)
        range = {*low, *high};
    else
        reader.refuse(node, name, "is not a range", "write [LOW, HIGH], from -1 to 1");
}

// What a table of a theme holds, each once; what nobody knows is refused.
struct ThemeReader {
    Reader& reader;
    std::string name;  // "themes.autumn week"
    const LettersWithoutFont& without_font;

    void read_day(const toml::node& node, const char* key, std::optional<std::chrono::year_month_day>& day) const {
        std::string text;
        if (reader.read_text(node, fmt::format("{}.{}", name, key), text,
                             [](const std::string& said) { parse_date(said); }))
            day = parse_date(text);
    }
    void read_locked(const toml::node& node, std::vector<std::string>& locked) const {
        const toml::array* list = node.as_array();
        if (list == nullptr) return reader.refuse(node, name + ".locked", "is not a list", "write [\"…\", \"…\"]");
        for (const toml::node& item : *list) {
            const auto aspect = item.value<std::string>();
            if (aspect && genome::aspect_named(*aspect) &&
                std::find(locked.begin(), locked.end(), *aspect) == locked.end())
                locked.push_back(*aspect);
            else
                reader.refuse(item, name + ".locked", "names no aspect, or one twice", "write trees, land or sky");
        }
    }
    void read_words_of(const toml::node& node, Theme& theme) const {
        if (!node.is_table())
            return reader.refuse(node, name + ".words", "must be a table", "write WORD = [LOW, HIGH]");
        for (const auto& [key, range] : *node.as_table()) {
            const std::string full = fmt::format("{}.words.{}", name, key.str());
            if (genome::word_named(key.str()))
                read_range(reader, range, full, theme.words[std::string(key.str())]);
            else
                reader.refuse(range, full, "is not known", "quadrat words show names all words");
        }
    }
    void read_texts_of(const toml::node& node, Theme& theme) const {
        if (!node.is_table()) return reader.refuse(node, name + ".text", "must be a table", "write [….text.LANGUAGE]");
        const auto spoken = genome::language_codes();
        for (const auto& [code, texts] : *node.as_table()) {
            const std::string full = fmt::format("{}.text.{}", name, code.str());
            if (!texts.is_table() || std::ranges::find(spoken, code.str()) == spoken.end())
                reader.refuse(texts, full, "is no language's table",
                              fmt::format("there are {}", fmt::join(spoken, ", ")));
            else
                read_texts_in(reader, *texts.as_table(), full, theme.texts, without_font);
        }
    }
    Theme read(const toml::table& table) const {
        Theme theme;
        for (const auto& [key, node] : table) {
            if (key == "from")
                read_day(node, "from", theme.from);
            else if (key == "until")
                read_day(node, "until", theme.until);
            else if (key == "locked")
                read_locked(node, theme.locked);
            else if (key == "words")
                read_words_of(node, theme);
            else if (key == "text")
                read_texts_of(node, theme);
            else
                reader.refuse(node, fmt::format("{}.{}", name, key.str()), "is not known",
                              "there are from, until, locked, words, text");
        }
        return theme;
    }
};

// A theme's days come in their order, and none is of two themes.
void check_days(Reader& reader, const toml::node& node, const std::string& name, const Configuration& configuration) {
    const Theme& theme = configuration.themes.at(name);
    if (theme.from.has_value() != theme.until.has_value() || (theme.from && *theme.until < *theme.from))
        return reader.refuse(node, "themes." + name, "has no days that could be counted",
                             "write from and until, the later day last, or neither");
    for (const auto& [other, its] : configuration.themes)
        if (other < name && theme.from && its.from && its.until && *its.from <= *theme.until &&
            *theme.from <= *its.until)
            reader.refuse(node, "themes." + name, fmt::format("has days that are of {} too", other),
                          "give each day to one theme");
}

void read_chosen_theme(Reader& reader, Configuration& configuration) {
    reader.read_checked("visit", "theme", configuration.visit.theme, [&](const std::string& name) {
        std::vector<std::string> known{kThemeByDate, kNoTheme};
        for (const auto& [theme, unused] : configuration.themes) known.push_back(theme);
        if (std::ranges::find(known, name) == known.end())
            throw base::InputError(fmt::format("is \"{}\"; it must be one of {}", name, fmt::join(known, ", ")));
    });
}

}  // namespace

void read_words(Reader& reader, std::map<std::string, std::array<double, 2>>& words) {
    for (const genome::Word& word : genome::vocabulary()) {
        const std::string name(word.name);
        const toml::node* node = reader.find("words", name.c_str());
        if (node != nullptr) read_range(reader, *node, "words." + name, words[name]);
    }
}

void read_themes(Reader& reader, Configuration& configuration, const LettersWithoutFont& without_font) {
    constexpr std::size_t kLongest = 60, kMost = 40;
    const toml::table* themes = reader.find_table("themes");
    if (themes == nullptr) return read_chosen_theme(reader, configuration);
    for (const auto& [key, node] : *themes) {
        const std::string name(key.str());
        reader.pass_over("themes", name);
        const bool is_name = !name.empty() && name.size() <= kLongest && name != kNoTheme && name != kThemeByDate &&
                             std::ranges::none_of(name, [](char c) { return static_cast<unsigned char>(c) < ' '; });
        if (!node.is_table() || !is_name || configuration.themes.size() >= kMost) {
            reader.refuse(node, "themes." + name, "is no theme",
                          fmt::format("write [themes.\"NAME\"], a name of {} bytes at most, {} of them at most",
                                      kLongest, kMost));
            continue;
        }
        configuration.themes[name] = ThemeReader{reader, "themes." + name, without_font}.read(*node.as_table());
    }
    for (const auto& [key, node] : *themes)
        if (configuration.themes.contains(std::string(key.str())))
            check_days(reader, node, std::string(key.str()), configuration);
    read_chosen_theme(reader, configuration);
}

}  // namespace quadrat::site
