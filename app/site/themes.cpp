// SPDX-License-Identifier: Apache-2.0
#include "site/themes.hpp"

#include <algorithm>

#include "site/configuration.hpp"

namespace quadrat::site {

std::string theme_on(const Configuration& configuration, std::optional<std::chrono::year_month_day> day) {
    const std::string& chosen = configuration.visit.theme;
    if (chosen == kNoTheme) return "";
    if (chosen != kThemeByDate) return chosen;
    for (const auto& [name, theme] : configuration.themes)
        if (day && theme.from && theme.until && *theme.from <= *day && *day <= *theme.until) return name;
    return "";
}

std::optional<std::chrono::year_month_day> day_on(const WallClock& wall) {
    return wall.is_trusted ? std::optional(wall.date) : std::nullopt;
}

Configuration with_theme(Configuration configuration, const std::string& name) {
    const auto found = configuration.themes.find(name);
    if (found == configuration.themes.end()) return configuration;
    const Theme& theme = found->second;
    for (const auto& [word, ends] : theme.words) configuration.words[word] = ends;
    std::vector<std::string>& locked = configuration.breeding.locked;
    for (const std::string& aspect : theme.locked)
        if (std::ranges::find(locked, aspect) == locked.end()) locked.push_back(aspect);
    for (const auto& [language, texts] : theme.texts)
        for (const auto& [key, words] : texts) configuration.texts_in[language][key] = words;
    return configuration;
}

}  // namespace quadrat::site
