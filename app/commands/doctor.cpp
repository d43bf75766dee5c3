// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "commands/calibrate.hpp"
#include "commands/commands.hpp"
#include "commands/learn_buttons.hpp"
#include "doctor/diagnosis.hpp"
#include "doctor/diagnosis_crash.hpp"
#include "machine/machine.hpp"
#include "site/settings.hpp"
#include "site/state_folder.hpp"
#include "site/wall_clock.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string configuration;
    std::string state;
    std::vector<std::string> only;
    bool learns_buttons = false;
    bool calibrates = false;
    bool is_json = false;
    std::string device;
    std::string map;
};

// By severity: 1 and 2 are a crash and bad usage, as everywhere.
constexpr int kStatus[] = {0, 3, 4};

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

std::vector<doctor::Finding> examine_parts(const Options& options) {
    const doctor::Examined examined = doctor::examine_configuration(
        site::tended_configuration(options.configuration, options.state), site::tended_state_folder(options.state));
    const site::Configuration& configuration = examined.configuration;
    // Who names another state folder has an exhibit of their own, and runs it themselves.
    const auto user = site::is_the_services(options.state) ? machine::account_named("quadrat") : std::nullopt;
    const std::pair<const char*, std::function<std::vector<doctor::Finding>()>> parts[] = {
        {"settings", [&] { return examined.findings; }},
        {"gpu", [] { return doctor::examine_gpu(); }},
        {"screen", [&] { return screen_findings(configuration, user); }},
        {"buttons", [&] { return button_findings(configuration, user); }},
        {"state", [&] { return doctor::examine_state(site::tended_state_folder(options.state), user); }},
        {"clock",
         [&] {
             const site::LastTimeSeen seen(site::tended_state_folder(options.state));
             return doctor::examine_clock(site::read_wall_clock(seen), configuration.hours);
         }},
        {"service", [&] { return service_findings(options.state); }},
    };
    std::vector<doctor::Finding> all;
    for (const auto& [name, look] : parts) {
        if (!options.only.empty() && std::ranges::find(options.only, name) == options.only.end()) continue;
        const std::vector<doctor::Finding> some = look();
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

int examine(const Options& options) {
    if (options.learns_buttons) {
        const auto map = options.map.empty() ? site::tended_state_folder(options.state) / "buttons.map"
                                             : std::filesystem::path(options.map);
        return learn_buttons(options.device, map);
    }
    if (options.calibrates) {
        return calibrate(site::settings_for_people(options.configuration).configuration,
                         site::state_folder(options.state));
    }
    const std::vector<doctor::Finding> all = examine_parts(options);
    std::fputs((options.is_json ? json_of(all) : doctor::report_of(all)).c_str(), stdout);
    return kStatus[static_cast<std::size_t>(doctor::worst_of(all))];
}

}  // namespace

void add_doctor(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "doctor",
        "Look at settings, GPU, screen, buttons, state, clock and service, and say what is wrong and what mends it.\n"
        "Ends with 0 when all is good, 3 when something is doubtful, 4 when something is bad");
    command
        ->add_option("--config", options->configuration,
                     "The site's settings, which are checked too; without it, the service's where it is installed")
        ->default_str("the service's, else none");
    command
        ->add_option("--state", options->state,
                     "Folder of what is kept between runs; without it, the service's where it is installed")
        ->default_str("the service's, else ~/.local/state/quadrat");
    command
        ->add_option("--only", options->only,
                     "Look at this part alone, repeatable: settings, gpu, screen, buttons, state, clock, service")
        ->check(CLI::IsMember({"settings", "gpu", "screen", "buttons", "state", "clock", "service"}))
        ->expected(1)
        ->take_all()
        ->default_str("all");
    command->add_flag("--json", options->is_json,
                      "Findings for other programs: part, verdict, what, remedy, file and line of each");
    command->add_flag("--learn-buttons", options->learns_buttons,
                      "Instead: learn what the buttons of a HID device are, by asking for them one after the other");
    command->add_flag("--calibrate", options->calibrates,
                      "Instead, with the exhibit stopped: measure in some ten seconds what this GPU draws, and keep\n"
                      "where the exhibit is to start");
    command
        ->add_option("--device", options->device,
                     "Which one learns, as after hid: (0079:0006, port=usb-…); any, without it")
        ->default_str("any");
    command->add_option("--map", options->map, "Where what was learned is kept (the state folder's buttons.map)")
        ->default_str("the state folder's buttons.map");
    command->callback([options, &chosen] { chosen = [options] { return examine(*options); }; });
}

}  // namespace quadrat::commands
