// SPDX-License-Identifier: Apache-2.0
#include "kiosk/state_folder.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "base/error.hpp"
#include "kiosk/staff/machine.hpp"

namespace quadrat::kiosk {

std::filesystem::path state_folder(const std::string& named) {
    if (!named.empty()) return named;
    if (const char* directory = std::getenv("STATE_DIRECTORY")) return directory;
    if (const char* state = std::getenv("XDG_STATE_HOME")) return std::filesystem::path(state) / "quadrat";
    if (const char* home = std::getenv("HOME")) return std::filesystem::path(home) / ".local/state/quadrat";
    return "quadrat-state";
}

std::filesystem::path existing_state_folder(const std::string& named) {
    std::error_code error;
    if (!named.empty() && !std::filesystem::is_directory(named, error))
        throw base::InputError(fmt::format("--state {}: there is no such folder", named));
    return state_folder(named);
}

std::filesystem::path tended_state_folder(const std::string& named, const ServiceFolders& service) {
    std::error_code error;
    if (named.empty() && std::filesystem::is_directory(service.state, error)) return service.state;
    return state_folder(named);
}

bool is_the_services(const std::string& named_state, const ServiceFolders& service) {
    std::error_code error;
    return named_state.empty() || std::filesystem::equivalent(named_state, service.state, error);
}

std::filesystem::path watched_folder(const std::string& named_state, const ServiceFolders& service) {
    std::error_code error;
    if (is_the_services(named_state, service) && std::filesystem::is_directory(service.runtime, error))
        return service.runtime;
    return staff::runtime_folder(state_folder(named_state));
}

}  // namespace quadrat::kiosk
