// SPDX-License-Identifier: Apache-2.0
#include "kiosk/state_folder.hpp"

#include <cstdlib>

#include "kiosk/staff/machine.hpp"

namespace quadrat::kiosk {

std::filesystem::path state_folder(const std::string& named) {
    if (!named.empty()) return named;
    if (const char* directory = std::getenv("STATE_DIRECTORY")) return directory;
    if (const char* state = std::getenv("XDG_STATE_HOME")) return std::filesystem::path(state) / "quadrat";
    if (const char* home = std::getenv("HOME")) return std::filesystem::path(home) / ".local/state/quadrat";
    return "quadrat-state";
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

std::filesystem::path tended_configuration(const std::string& named, const std::string& named_state,
                                           const ServiceFolders& service) {
    if (!named.empty()) return named;
    std::error_code error;
    // A service whose file is gone has lost its settings: that is to be found, not passed over.
    const bool is_installed =
        std::filesystem::exists(service.configuration, error) || std::filesystem::is_directory(service.state, error);
    return is_installed && is_the_services(named_state, service) ? service.configuration : std::filesystem::path{};
}

}  // namespace quadrat::kiosk
