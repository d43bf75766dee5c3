// SPDX-License-Identifier: Apache-2.0
#include "commands/fleet_orders.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>

#include "base/error.hpp"
#include "commands/desk_curator.hpp"
#include "commands/staff_acts.hpp"
#include "genome/speech.hpp"
#include "site/curation.hpp"
#include "staff/watch.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWho = "the broker";

std::vector<std::string> choices(const site::Configuration& now, const std::string& what) {
    std::vector<std::string> all;
    if (what == "language") {
        for (const std::string_view code : genome::language_codes()) all.emplace_back(code);
        return all;
    }
    all = {site::kThemeByDate, site::kNoTheme};
    for (const auto& [name, theme] : now.themes) all.push_back(name);
    return all;
}

const std::string& value_of(const site::Configuration& configuration, const std::string& what) {
    return what == "theme" ? configuration.visit.theme : configuration.visit.language;
}

// What the site says itself is not said again, as at the desk.
void choose(const site::Curation& curation, const std::string& what, const std::string& value) {
    const auto known = choices(curation.now().configuration, what);
    if (std::ranges::find(known, value) == known.end())
        throw base::InputError(fmt::format("there is no such {}; there are {}", what, fmt::join(known, ", ")));
    const bool is_the_sites = value_of(curation.of_the_site().configuration, what) == value;
    const auto at = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    try {
        curation.change({{{"visit", what}, is_the_sites ? std::nullopt : std::optional<site::CuratedValue>(value)}},
                        {at, kWho, what == "theme" ? "themes" : "visit", ""});
    } catch (const site::SettingsError& error) {
        throw base::InputError(in_one_line(error));
    }
}

void do_order(const site::Curation& curation, const fs::path& runtime, const std::string& what,
              const std::string& value) {
    if (what == "theme" || what == "language") return choose(curation, what, value);
    if (what == "restart") return do_act(runtime, desk::Act::Restart);
    do_act(runtime, what == "standby" && value == "on" ? desk::Act::StandBy : desk::Act::Wake);
}

}  // namespace

fleet::Orders fleet_orders(const fs::path& file, const fs::path& state, const fs::path& runtime) {
    const site::Curation curation(file, state);
    fleet::Orders orders;
    orders.carry_out = [curation, state, runtime](const std::string& what, const std::string& value) {
        do_order(curation, runtime, what, value);
        note_act(state, "fleet", fmt::format("{} asked for {} {}", kWho, what, value));
    };
    orders.state = [curation, runtime] {
        const site::Configuration now = curation.now().configuration;
        std::error_code error;
        return std::map<std::string, std::string>{
            {"standby", fs::exists(runtime / staff::kStandBy, error) ? "on" : "off"},
            {"theme", now.visit.theme},
            {"language", now.visit.language}};
    };
    orders.choices = [curation](const std::string& what) { return choices(curation.now().configuration, what); };
    return orders;
}

}  // namespace quadrat::commands
