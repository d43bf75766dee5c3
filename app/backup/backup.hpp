// SPDX-License-Identifier: Apache-2.0
// The room `backup`: a site's state in one file, and putting it back; who holds the state folder meanwhile.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "archive/archive.hpp"
#include "site/configuration.hpp"

// All that a machine needs to take the place of another, in one file; and how it is put there.
namespace quadrat::backup {

// Hears which part is at work and the share that is done; what it throws ends the work, and nothing has changed.
using Progress = std::function<void(const std::string& part, double share)>;

struct Places {
    std::filesystem::path state;
    std::filesystem::path settings;  // "" for none
    archive::WallTime now;
};

// Also beside a running exhibit. Whole or not at all; what lies there is replaced where it is a backup too. Returns
// what is in it and what is not, a line each. Throws InputError naming the file.
std::vector<std::string> write_backup(const Places& places, const std::filesystem::path& to, const Progress& progress);

enum class Identity {
    OfTheBackup,   // this machine takes the place of the one that is gone
    OfTheMachine,  // this is another: it has no visits yet, and no name in the fleet but its own
};
enum class Settings { Restore, Leave };

struct RestoreOptions {
    Identity identity = Identity::OfTheBackup;
    Settings settings = Settings::Restore;
};

// The whole backup is checked before anything is touched; then all of it takes the place of what was there, which
// lies under a dated name in the state folder. Whoever calls it holds the state's lock. Returns what was restored, a
// line each. Throws InputError.
std::vector<std::string> restore(const Places& places, const std::filesystem::path& backup,
                                 const RestoreOptions& options, const Progress& progress);

}  // namespace quadrat::backup
