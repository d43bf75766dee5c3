// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

namespace quadrat::site {

// Where visits are kept: the named folder, else the service's ($STATE_DIRECTORY, the first of several), else the
// user's: $XDG_STATE_HOME/quadrat, $HOME/.local/state/quadrat, the same in the home that the system knows of them, and
// last quadrat-state where the program was started. A variable that is empty or names no absolute path is passed over,
// as the XDG Base Directory Specification says.
std::filesystem::path state_folder(const std::string& named);

// For those who only read there. Throws InputError where a folder is named and there is none.
void require_state_folder(const std::string& named);
// The same for tools that read what is there: one that is named must be. Throws InputError.
std::filesystem::path existing_state_folder(const std::string& named);

// The folders of the installed service.
struct ServiceFolders {
    std::filesystem::path state = "/var/lib/quadrat";
    std::filesystem::path runtime = "/run/quadrat";
    std::filesystem::path configuration = "/etc/quadrat/quadrat.toml";
};

// The same for whoever looks after an exhibit from a terminal: the named folder, else the installed service's where
// there is one, else as above.
std::filesystem::path tended_state_folder(const std::string& named, const ServiceFolders& service = {});

// Whether the installed service is meant: no other state folder is named.
bool is_the_services(const std::string& named_state, const ServiceFolders& service = {});

// The folder in which a running exhibit tells how it is and looks for requests: the installed service's, unless the
// state folder of another is named.
std::filesystem::path watched_folder(const std::string& named_state, const ServiceFolders& service = {});

// The settings that whoever looks after an exhibit means: the named file, else the installed service's where there is a
// service, else none.
std::filesystem::path tended_configuration(const std::string& named, const std::string& named_state,
                                           const ServiceFolders& service = {});

}  // namespace quadrat::site
