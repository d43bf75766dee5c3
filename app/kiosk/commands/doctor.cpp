// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>

#include "kiosk/commands/commands.hpp"
#include "kiosk/diagnosis.hpp"
#include "kiosk/state_folder.hpp"

namespace quadrat::kiosk::commands {
namespace {

struct Options {
    std::string configuration;
    std::string state;
};

constexpr int kTroubleFound = 1;

int examine(const Options& options) {
    const Configuration configuration =
        options.configuration.empty() ? Configuration{} : read_configuration(options.configuration);
    std::vector<Finding> all;
    const auto add = [&](std::vector<Finding> some) { all.insert(all.end(), some.begin(), some.end()); };
    add(examine_gpu());
    add(examine_screen());
    add(examine_buttons(configuration));
    add(examine_state(state_folder(options.state)));
    add(examine_clock());
    std::fputs(report_of(all).c_str(), stdout);
    const bool is_bad = std::ranges::any_of(all, [](const Finding& f) { return f.health == Health::Bad; });
    return is_bad ? kTroubleFound : 0;
}

}  // namespace

void add_doctor(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "doctor",
        "Look at GPU, screen, permissions, buttons, state and clock, and say what to do; 1 when something is bad");
    command->add_option("--config", options->configuration, "The site's settings");
    command->add_option("--state", options->state, "Folder of what is kept between runs");
    command->callback([options, &chosen] { chosen = [options] { return examine(*options); }; });
}

}  // namespace quadrat::kiosk::commands
