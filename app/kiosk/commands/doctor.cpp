// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>

#include "kiosk/commands/calibrate.hpp"
#include "kiosk/commands/commands.hpp"
#include "kiosk/commands/learn_buttons.hpp"
#include "kiosk/diagnosis.hpp"
#include "kiosk/staff/machine.hpp"
#include "kiosk/state_folder.hpp"

namespace quadrat::kiosk::commands {
namespace {

struct Options {
    std::string configuration;
    std::string state;
    bool learns_buttons = false;
    bool calibrates = false;
    std::string device;
    std::string map;
};

// By severity: 1 and 2 are a crash and bad usage, as everywhere.
constexpr int kStatus[] = {0, 3, 4};

int examine(const Options& options) {
    if (options.learns_buttons) {
        const auto map =
            options.map.empty() ? state_folder(options.state) / "buttons.map" : std::filesystem::path(options.map);
        return learn_buttons(options.device, map.string());
    }
    if (options.calibrates) {
        const Configuration configuration =
            options.configuration.empty() ? Configuration{} : read_configuration(options.configuration);
        return calibrate(configuration, state_folder(options.state));
    }
    Examined examined = examine_configuration(options.configuration);
    std::vector<Finding> all = std::move(examined.findings);
    const auto add = [&](std::vector<Finding> some) { all.insert(all.end(), some.begin(), some.end()); };
    const auto state = state_folder(options.state);
    add(examine_gpu());
    add(examine_screen());
    add(examine_buttons(examined.configuration));
    add(examine_state(state));
    add(examine_clock(staff::read_wall_clock(), !examined.configuration.hours.is_always_open));
    add(examine_service(staff::runtime_folder(state)));
    std::fputs(report_of(all).c_str(), stdout);
    return kStatus[static_cast<std::size_t>(worst_of(all))];
}

}  // namespace

void add_doctor(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "doctor",
        "Look at settings, GPU, screen, buttons, state, clock and service, and say what is wrong and what mends it.\n"
        "Ends with 0 when all is good, 3 when something is doubtful, 4 when something is bad");
    command->add_option("--config", options->configuration, "The site's settings, which are checked too");
    command->add_option("--state", options->state, "Folder of what is kept between runs");
    command->add_flag("--learn-buttons", options->learns_buttons,
                      "Instead: learn what the buttons of a HID device are, by asking for them one after the other");
    command->add_flag("--calibrate", options->calibrates,
                      "Instead, with the exhibit stopped: measure in some ten seconds what this GPU draws, and keep\n"
                      "where the exhibit is to start");
    command->add_option("--device", options->device,
                        "Which one learns, as after hid: (0079:0006, port=usb-…); any, without it");
    command->add_option("--map", options->map, "Where what was learned is kept (the state folder's buttons.map)");
    command->callback([options, &chosen] { chosen = [options] { return examine(*options); }; });
}

}  // namespace quadrat::kiosk::commands
