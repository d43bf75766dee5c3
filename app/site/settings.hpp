// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "site/configuration.hpp"

namespace quadrat::site {

// Where the settings in use come from.
enum class SettingsFrom { File, LastGood, Defaults };

// What a run or a publisher begins with.
struct Settings {
    Configuration configuration;
    SettingsFrom from = SettingsFrom::File;
    std::string toml;                 // what the configuration was read from; "" for the defaults
    std::filesystem::path file;       // that was named; "" for none
    std::optional<std::string> held;  // by the files at the start; nothing where the site's could not be read
    std::vector<Mistake> mistakes;    // why they are not the file's
};

// What the curator says at the desk lies in the state folder, and over the site's file (layers.hpp). `state` may be "":
// then there is none.
std::filesystem::path curated_file(const std::filesystem::path& state);

// The site's file, "" for none, with what the curator says over it. `toml` receives both, or nothing where the site's
// cannot be read. One of the curator's that cannot be read is a mistake.
CheckedConfiguration check_settings(const std::filesystem::path& file, const std::filesystem::path& state,
                                    std::optional<std::string>* toml = nullptr);

// For people at a command line: the file's, or the defaults where none is named. Throws SettingsError with all
// mistakes.
Settings settings_for_people(const std::filesystem::path& file, const std::filesystem::path& state);

// For a service, which must not stay dark for a typo: the file's; where it has a mistake, the last that worked, as far
// as they are still right; where there are none, the defaults. Never throws.
Settings settings_for_service(const std::filesystem::path& file, const std::filesystem::path& state);

// What comes after settings that were right by themselves and did not work on this machine, and why they did not.
// Nothing after the defaults.
std::optional<Settings> next_settings(Settings failed, const std::filesystem::path& state, Mistake why);

// What safe mode does about settings that are right, but not those that worked last: they may be why it failed so
// often.
Settings safe_settings(Settings settings, const std::filesystem::path& state, int failures);

// Says in the log what is wrong, and what is used instead.
void tell(const Settings& settings);

// The settings that worked last, in the state folder. Keeping them writes nothing where they are kept already, and
// throws InputError where it cannot.
std::filesystem::path last_good_file(const std::filesystem::path& state);
void keep_last_good(const std::filesystem::path& state, const std::string& toml);

// What a pulled plug leaves of a file may be read without complaint: "rounds = 1" of "rounds = 12". It is known by the
// settings from before, of which it is the beginning as far as the middle of a line. Nothing: it is not.
std::optional<Mistake> cut_off(const std::string& toml_now, const std::string& toml_before, const std::string& source);
std::optional<Mistake> cut_off_from_last_good(const std::filesystem::path& file, const std::filesystem::path& state);

// For people: "the last settings that worked are used".
std::string in_words(SettingsFrom from);

}  // namespace quadrat::site
