// SPDX-License-Identifier: Apache-2.0
#include "commands/curator_themes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "commands/curator_entries.hpp"
#include "genome/speech.hpp"

namespace quadrat::commands {
namespace {

using site::Configuration;
using site::Edit;

std::string theme_address(const std::string& name) {
    std::string address = "/curator/theme?name=";
    for (const char c : name) address += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    return address;
}

std::vector<Edit> edits_of_theme(const std::string& name, const site::Theme& theme) {
    std::vector<Edit> edits{{{"themes", name}, site::EmptyTable{}}};
    if (theme.from) edits.push_back({{"themes", name, "from"}, site::date_text(*theme.from)});
    if (theme.until) edits.push_back({{"themes", name, "until"}, site::date_text(*theme.until)});
    if (!theme.locked.empty()) edits.push_back({{"themes", name, "locked"}, theme.locked});
    for (const auto& [word, ends] : theme.words) edits.push_back({{"themes", name, "words", word}, ends});
    for (const auto& [code, texts] : theme.texts)
        for (const auto& [key, words] : texts) edits.push_back({{"themes", name, "text", code, key}, words});
    return edits;
}

}  // namespace

Form themes_form(const Configuration& now, const Texts& say) {
    Form form;
    form.hint = say("themes.hint");
    Entry shown{Kind::Choice, "theme", say("themes.shown"), now.visit.theme};
    shown.options = {{site::kThemeByDate, say("themes.by-date")}, {site::kNoTheme, say("themes.none")}};
    for (const auto& [name, theme] : now.themes) {
        shown.options.push_back({name, name});
        const std::string days =
            theme.from ? fmt::format(" ({} – {})", site::date_text(*theme.from), site::date_text(*theme.until)) : "";
        form.others.push_back({theme_address(name), name + days});
    }
    form.others.push_back({"/curator/theme", say("themes.new")});
    form.groups = {{say("themes.now"), "", {shown}}};
    return form;
}

Form theme_form(const Fields& query, const Configuration& now, const Texts& say) {
    const std::string name = value_in(query, "name");
    const auto found = now.themes.find(name);
    const site::Theme theme = found == now.themes.end() ? site::Theme{} : found->second;
    const std::string code = spoken_in(query, now);
    Form form;
    form.kept = {{"in", code}, {"part", "theme"}};
    if (found != now.themes.end()) {
        form.kept.emplace("name", name);
        form.remove = say("theme.remove");
        form.others = languages_beside(theme_address(name) + "&");
        form.current = theme_address(name) + "&in=" + code;
    }
    Entry from{Kind::Day, "from", say("theme.from"), theme.from ? site::date_text(*theme.from) : ""};
    Entry until{Kind::Day, "until", say("theme.until"), theme.until ? site::date_text(*theme.until) : ""};
    form.groups = {{say("theme.name"), "", {{Kind::Line, "called", say("theme.name"), name}}},
                   {say("theme.days"), say("theme.days.hint"), {from, until}},
                   locks(theme.locked, say)};
    for (const genome::Aspect aspect : genome::kAspects) form.groups.push_back(words_of(aspect, theme.words, say));
    const auto own = theme.texts.find(code);
    form.groups.push_back(
        texts_of(code, own == theme.texts.end() ? std::map<std::string, std::string>{} : own->second, say));
    return form;
}

std::vector<Edit> theme_edits(const Fields& fields, desk::Curator::Deed deed, const Configuration& now,
                              const Configuration& site) {
    const std::string before = value_in(fields, "name");
    const std::string name = value_in(fields, "called");
    if (deed == desk::Curator::Deed::Remove) {
        if (site.themes.contains(before))
            throw base::InputError(fmt::format("\"{}\" is in the site's settings; take it out there", before));
        std::vector<Edit> edits{{{"themes", before}, std::nullopt}};
        if (now.visit.theme == before) edits.push_back({{"visit", "theme"}, std::string(site::kThemeByDate)});
        return edits;
    }
    if (name.empty()) throw base::InputError("a theme needs a name; write one such as autumn week");
    if (name != before && now.themes.contains(name))
        throw base::InputError(fmt::format("there is a theme \"{}\" already; choose another name", name));
    std::vector<Edit> edits;
    // The curator's themes stand in the place of the site's: what was there comes along.
    for (const auto& [other, theme] : now.themes) {
        if (other == before || other == name) continue;
        for (Edit& edit : edits_of_theme(other, theme)) edits.push_back(std::move(edit));
    }
    site::Theme theme;
    if (const auto found = now.themes.find(before); found != now.themes.end()) theme.texts = found->second.texts;
    for (const auto& [key, day] : {std::pair{"from", &theme.from}, std::pair{"until", &theme.until}}) {
        const std::string written = value_in(fields, key);
        try {
            if (!written.empty()) *day = site::parse_date(written);
        } catch (const std::invalid_argument& error) {
            throw base::InputError(error.what());
        }
    }
    theme.locked = locked_in(fields);
    for (const genome::Word& word : genome::vocabulary())
        if (const auto range = range_in(fields, word.name)) theme.words[std::string(word.name)] = *range;
    theme.texts[spoken_in(fields, now)] = texts_in(fields);
    if (!before.empty() && before != name) edits.push_back({{"themes", before}, std::nullopt});
    edits.push_back({{"themes", name}, std::nullopt});
    for (Edit& edit : edits_of_theme(name, theme)) edits.push_back(std::move(edit));
    if (now.visit.theme == before && before != name && !before.empty()) edits.push_back({{"visit", "theme"}, name});
    return edits;
}

}  // namespace quadrat::commands
