// SPDX-License-Identifier: Apache-2.0
#include "commands/examine.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>

#include "doctor/diagnosis_crash.hpp"
#include "fleet/identity.hpp"
#include "machine/machine.hpp"
#include "projector/projector.hpp"
#include "site/settings.hpp"
#include "site/state_folder.hpp"
#include "site/wall_clock.hpp"

namespace quadrat::commands {
namespace {

std::vector<doctor::Finding> service_findings(const std::string& state) {
    std::vector<doctor::Finding> findings = doctor::examine_service(site::watched_folder(state));
    if (!site::is_the_services(state)) return findings;
    const std::vector<doctor::Finding> unit = doctor::examine_unit(machine::read_unit_state("quadrat.service"));
    findings.insert(findings.begin(), unit.begin(), unit.end());
    const auto now = std::chrono::system_clock::now();
    const std::vector<doctor::Finding> crash =
        doctor::examine_crashes(doctor::kCrashFolder, machine::account_named("quadrat"), now);
    findings.insert(findings.end(), crash.begin(), crash.end());
    return findings;
}

std::vector<doctor::Finding> button_findings(const site::Configuration& configuration,
                                             const std::optional<machine::Account>& user) {
    std::vector<doctor::Finding> findings = doctor::examine_buttons(configuration, user);
    const std::vector<doctor::Finding> boards = doctor::examine_boards(configuration);
    findings.insert(findings.end(), boards.begin(), boards.end());
    return findings;
}

std::vector<doctor::Finding> screen_findings(const site::Configuration& configuration,
                                             const std::optional<machine::Account>& user) {
    std::vector<doctor::Finding> findings = doctor::examine_screen(user);
    const std::vector<doctor::Finding> wanted = doctor::examine_wanted_screen(configuration);
    findings.insert(findings.end(), wanted.begin(), wanted.end());
    return findings;
}

std::vector<doctor::Finding> projector_findings(const site::Configuration& configuration, const std::string& state) {
    return doctor::examine_projector(
        configuration, site::watched_folder(state), [](const site::Configuration::Screen& screen) {
            constexpr std::chrono::seconds kPatience{3};
            const std::string& file = screen.power_password_file;
            return std::string(
                name_of(projector::open_projector(projector::parse_address(screen.power),
                                                  file.empty() ? "" : fleet::password_in(file), kPatience)
                            ->power()));
        });
}

}  // namespace

std::vector<doctor::Finding> examine_parts(const std::string& named_configuration, const std::string& named_state,
                                           const std::vector<std::string>& only) {
    const doctor::Examined examined = doctor::examine_configuration(
        site::tended_configuration(named_configuration, named_state), site::tended_state_folder(named_state));
    const site::Configuration& configuration = examined.configuration;
    site::use_zone(configuration.zone);
    // Who names another state folder has an exhibit of their own, and runs it themselves.
    const auto user = site::is_the_services(named_state) ? machine::account_named("quadrat") : std::nullopt;
    const std::pair<const char*, std::function<std::vector<doctor::Finding>()>> parts[] = {
        {"settings", [&] { return examined.findings; }},
        {"gpu", [] { return doctor::examine_gpu(); }},
        {"screen", [&] { return screen_findings(configuration, user); }},
        {"projector", [&] { return projector_findings(configuration, named_state); }},
        {"buttons", [&] { return button_findings(configuration, user); }},
        {"sound", [&] { return doctor::examine_sound(configuration, user); }},
        {"state", [&] { return doctor::examine_state(site::tended_state_folder(named_state), user); }},
        {"clock",
         [&] {
             const site::LastTimeSeen seen(site::tended_state_folder(named_state));
             return doctor::examine_clock(site::read_wall_clock(seen), configuration.hours);
         }},
        {"service", [&] { return service_findings(named_state); }},
    };
    std::vector<doctor::Finding> all;
    for (const auto& [name, look] : parts) {
        if (!only.empty() && std::ranges::find(only, name) == only.end()) continue;
        const std::vector<doctor::Finding> some = look();
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

}  // namespace quadrat::commands
