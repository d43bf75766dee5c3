// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace quadrat::site {

struct Configuration;
struct WallClock;

// The screen's words that a site has instead of a language's own: by the language's code, then by key.
using TextsByLanguage = std::map<std::string, std::map<std::string, std::string>>;

// What a site shows for some days: "autumn week".
struct Theme {
    std::optional<std::chrono::year_month_day> from, until;  // both days are of it; none: it is shown when it is chosen
    std::map<std::string, std::array<double, 2>> words;      // over the site's own limits
    std::vector<std::string> locked;                         // besides those of the site
    TextsByLanguage texts;                                   // before those of the site
    friend bool operator==(const Theme&, const Theme&) = default;
};

inline constexpr const char* kNoTheme = "none";         // chosen: no theme, whatever the date
inline constexpr const char* kThemeByDate = "by date";  // chosen: the one of the day, if any

// The theme that is chosen, else that of the day; "" for none. Without a date, as where the clock is not to be trusted,
// none is of the day.
std::string theme_on(const Configuration& configuration, std::optional<std::chrono::year_month_day> day);

std::optional<std::chrono::year_month_day> day_on(const WallClock& wall);  // nothing where it is not to be trusted

// The configuration with that theme's words, locks and texts over its own. `name` may be "": then as it is.
Configuration with_theme(Configuration configuration, const std::string& name);

}  // namespace quadrat::site
