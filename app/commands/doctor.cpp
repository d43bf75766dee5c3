// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "commands/calibrate.hpp"
#include "commands/commands.hpp"
#include "commands/examine.hpp"
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

int examine(const Options& options) {
    if (options.learns_buttons) {
        const auto map = options.map.empty() ? site::tended_state_folder(options.state) / "buttons.map"
                                             : std::filesystem::path(options.map);
        return learn_buttons(options.device, map);
    }
    if (options.calibrates) {
        return calibrate(
            site::settings_for_people(options.configuration, site::tended_state_folder(options.state)).configuration,
            site::state_folder(options.state));
    }
    const std::vector<doctor::Finding> all = examine_parts(options.configuration, options.state, options.only);
    std::fputs((options.is_json ? json_of(all) : doctor::report_of(all)).c_str(), stdout);
    return kStatus[static_cast<std::size_t>(doctor::worst_of(all))];
}

}  // namespace

void add_doctor(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand(
        "doctor",
        "Look at settings, GPU, screen, projector, buttons, sound, state, clock and service, and say what is "
        "wrong and what mends it.\n"
        "Ends with 0 when all is good, 3 when something is doubtful, 4 when something is bad");
    command
        .add_option("--config", options->configuration,
                    "The site's settings, which are checked too; without it, the service's where it is installed")
        .tells_default("the service's, else none");
    command
        .add_option("--state", options->state,
                    "Folder of what is kept between runs; without it, the service's where it is installed")
        .tells_default("the service's, else ~/.local/state/quadrat");
    command
        .add_option(
            "--only", options->only,
            "Look at this part alone, repeatable: settings, gpu, screen, projector, buttons, sound, state, clock, "
            "service")
        .among({"settings", "gpu", "screen", "projector", "buttons", "sound", "state", "clock", "service"})
        .takes(1)
        .keeps_all()
        .tells_default("all");
    command.add_flag("--json", options->is_json,
                     "Findings for other programs: part, verdict, what, remedy, file and line of each");
    command.add_flag("--learn-buttons", options->learns_buttons,
                     "Instead: learn what the buttons of a HID device are, by asking for them one after the other");
    command.add_flag("--calibrate", options->calibrates,
                     "Instead, with the exhibit stopped: measure in some ten seconds what this GPU draws, and keep\n"
                     "where the exhibit is to start");
    command
        .add_option("--device", options->device,
                    "Which one learns, as after hid: (0079:0006, port=usb-…); any, without it")
        .tells_default("any");
    command.add_option("--map", options->map, "Where what was learned is kept (the state folder's buttons.map)")
        .tells_default("the state folder's buttons.map");
    command.does([options] { return examine(*options); });
}

}  // namespace quadrat::commands
