// SPDX-License-Identifier: Apache-2.0
#include "site/state_folder.hpp"

#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>

#include <vector>

#include "base/error.hpp"
#include "machine/machine.hpp"

namespace quadrat::site {
namespace {

std::filesystem::path home_that_the_system_knows() {
    constexpr std::size_t kEnough = 16384;
    std::vector<char> buffer(kEnough);
    passwd entry{};
    passwd* found = nullptr;
    ::getpwuid_r(::getuid(), &entry, buffer.data(), buffer.size(), &found);
    const std::filesystem::path home = found == nullptr ? "" : found->pw_dir;
    std::error_code error;
    return home.is_absolute() && std::filesystem::is_directory(home, error) ? home : std::filesystem::path();
}

}  // namespace

std::filesystem::path state_folder(const std::string& named) {
    if (!named.empty()) return named;
    if (auto service = machine::folder_in("STATE_DIRECTORY"); !service.empty()) return service;
    if (const auto state = machine::folder_in("XDG_STATE_HOME"); !state.empty()) return state / "quadrat";
    for (const auto& home : {machine::folder_in("HOME"), home_that_the_system_knows()})
        if (!home.empty()) return home / ".local/state/quadrat";
    return "quadrat-state";
}

void require_state_folder(const std::string& named) {
    std::error_code error;
    if (!named.empty() && !std::filesystem::is_directory(named, error))
        throw base::InputError(fmt::format(
            "--state {}: there is no such folder; name the exhibit's, as /var/lib/quadrat, or leave it out", named));
}

std::filesystem::path existing_state_folder(const std::string& named) {
    require_state_folder(named);
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
    return machine::runtime_folder(state_folder(named_state));
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

}  // namespace quadrat::site
