// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "site/configuration.hpp"

namespace quadrat::backup {

inline constexpr const char* kManifest = "quadrat-backup.json";  // the first of a backup
inline constexpr std::string_view kStateFolder = "state/";       // before the names of the site's files
inline constexpr std::string_view kSettingsFolder = "settings/";
inline constexpr const char* kSettings = "settings/quadrat.toml";  // whatever it is called on a machine
inline constexpr std::size_t kLargest = std::size_t{64} << 20U;    // of what is not the state file

// What a backup says of itself.
struct Manifest {
    std::string program;  // that made it: its version
    std::string host;
    std::string made_at;                         // "2026-11-26 11:20:00 UTC"
    std::map<std::string, std::uint64_t> files;  // bytes of each, by its name in the archive
};

std::string to_json(const Manifest& manifest);
// Throws InputError naming the source: what is wrong, or that a newer program made it.
Manifest manifest_from(std::string_view json, const std::string& source);

// Of a backup; throws InputError where it is none. Not all of it is read.
Manifest manifest_of(const std::filesystem::path& backup);

// What the settings name besides themselves: who vouches for a broker, its password, maps of buttons.
std::vector<std::filesystem::path> files_named_in(const site::Configuration& configuration);

// The settings of another exhibit, without the name that the first one has in its fleet: the machine's counts then.
// Throws InputError where that is to be done by hand.
std::string without_fleet_name(const std::string& toml, const std::string& source);

}  // namespace quadrat::backup
