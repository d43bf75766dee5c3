// SPDX-License-Identifier: Apache-2.0
#include "site/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/file.hpp"
#include "base/log.hpp"
#include "site/layers.hpp"

namespace quadrat::site {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargest = 1U << 20U;

std::optional<std::string> last_good(const fs::path& state) {
    try {
        return base::read_file(last_good_file(state), kLargest);
    } catch (const base::InputError&) {
        return std::nullopt;
    }
}

// Instead of those that have the mistakes.
Settings second_best(Settings wrong, const fs::path& state) {
    auto kept = last_good(state);
    if (wrong.from == SettingsFrom::LastGood || kept == wrong.toml) kept.reset();
    // What the curator said is no reason to forget what the site says.
    const bool is_curators = !wrong.mistakes.empty() && wrong.mistakes.front().file == curated_file(state).string();
    if (!kept && is_curators) kept = layers_of(wrong.toml).below;
    // Another version of the program may find something wrong in them; the rest of them is still better than nothing.
    wrong.configuration =
        kept ? check_configuration(*kept, last_good_file(state).string()).configuration : Configuration{};
    wrong.from = kept ? SettingsFrom::LastGood : SettingsFrom::Defaults;
    wrong.toml = std::move(kept).value_or("");
    return wrong;
}

// What is said at the desk; "" where nothing is. Throws InputError.
std::string curated_in(const fs::path& state) {
    std::error_code error;
    if (state.empty() || !fs::exists(curated_file(state), error)) return "";
    std::string curated = base::read_file(curated_file(state), kLargest);
    if (curated.empty()) throw base::InputError(curated_file(state).string() + ": the file is empty");
    return curated;
}

Settings read(const fs::path& file, const fs::path& state) {
    Settings settings;
    settings.file = file;
    CheckedConfiguration checked = check_settings(file, state, &settings.held);
    settings.configuration = std::move(checked.configuration);
    settings.mistakes = std::move(checked.mistakes);
    settings.toml = settings.held.value_or("");
    return settings;
}

}  // namespace

fs::path curated_file(const fs::path& state) { return state / "desk.toml"; }

CheckedConfiguration check_settings(const fs::path& file, const fs::path& state, std::optional<std::string>* toml) {
    std::optional<std::string> below = "# no file of settings is named\n";
    if (!file.empty()) {
        below.reset();
        CheckedConfiguration checked = check_configuration_file(file, &below);
        if (!checked.is_usable()) {
            if (toml != nullptr) *toml = std::move(below);
            return checked;
        }
    }
    try {
        const std::string both = laid_over(*below, curated_in(state), curated_file(state).string());
        if (toml != nullptr) *toml = both;
        return check_configuration(both, file.string());
    } catch (const base::InputError& error) {
        if (toml != nullptr) *toml = std::move(below);
        return {{}, {{curated_file(state).string(), 0, error.what(), "undo the last change at the desk"}}};
    }
}

Settings settings_for_people(const fs::path& file, const fs::path& state) {
    Settings settings = read(file, state);
    if (!settings.mistakes.empty()) throw SettingsError(std::move(settings.mistakes));
    return settings;
}

Settings settings_for_service(const fs::path& file, const fs::path& state) {
    Settings settings = read(file, state);
    if (settings.mistakes.empty() && settings.held)
        if (auto cut = cut_off(*settings.held, last_good(state).value_or(""), file.string()))
            settings.mistakes.push_back(std::move(*cut));
    return settings.mistakes.empty() ? settings : second_best(std::move(settings), state);
}

std::optional<Settings> next_settings(Settings failed, const fs::path& state, Mistake why) {
    if (failed.from == SettingsFrom::Defaults || failed.file.empty()) return std::nullopt;
    failed.mistakes.push_back(std::move(why));
    return second_best(std::move(failed), state);
}

Settings safe_settings(Settings settings, const fs::path& state, int failures) {
    const auto kept = last_good(state);
    if (settings.from != SettingsFrom::File || settings.file.empty() || !kept || *kept == settings.toml)
        return settings;
    Mistake why{settings.file.string(), 0,
                fmt::format("the exhibit failed {} times in ten minutes, and these settings are not those that worked",
                            failures),
                "take back what was changed last; see why: journalctl -u quadrat -p err -n 50"};
    return *next_settings(std::move(settings), state, std::move(why));
}

void tell(const Settings& settings) {
    for (const Mistake& mistake : settings.mistakes) base::log::error("configuration: {}", to_text(mistake));
    if (!settings.mistakes.empty())
        base::log::error("configuration: {}; correct {}, then it is taken over", in_words(settings.from),
                         settings.file.string());
}

fs::path last_good_file(const fs::path& state) { return state / "last-good.toml"; }

void keep_last_good(const fs::path& state, const std::string& toml) {
    if (last_good(state) == toml) return;
    std::error_code error;
    fs::create_directories(state, error);
    base::write_file(last_good_file(state), toml);
}

std::optional<Mistake> cut_off(const std::string& toml_now, const std::string& toml_before, const std::string& source) {
    const std::string_view toml = layers_of(toml_now).below, before = layers_of(toml_before).below;
    if (toml.empty() || toml.back() == '\n' || toml.size() >= before.size() || !before.starts_with(toml))
        return std::nullopt;
    if (before[toml.size()] == '\n' || before[toml.size()] == '\r')
        return std::nullopt;  // a whole line is nobody's slip
    return Mistake{source, static_cast<int>(std::ranges::count(toml, '\n')) + 1,
                   "the file ends in the middle of this line, and had more when it worked",
                   "put the rest back: the settings that worked last are last-good.toml in the state folder"};
}

std::optional<Mistake> cut_off_from_last_good(const fs::path& file, const fs::path& state) {
    const auto kept = state.empty() ? std::nullopt : last_good(state);
    try {
        return kept ? cut_off(base::read_file(file, kLargest), *kept, file.string()) : std::nullopt;
    } catch (const base::InputError&) {
        return std::nullopt;  // which is a mistake of its own
    }
}

std::string in_words(SettingsFrom from) {
    switch (from) {
        case SettingsFrom::File:
            return "the settings from before the change are used";
        case SettingsFrom::LastGood:
            return "the last settings that worked are used";
        case SettingsFrom::Defaults:
            break;
    }
    return "no settings that worked are kept, so the defaults are used";
}

}  // namespace quadrat::site
