// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>

#include "base/error.hpp"
#include "exhibit/archive.hpp"
#include "exhibit/state_file.hpp"
#include "kiosk/commands/commands.hpp"
#include "kiosk/state_folder.hpp"
#include "kiosk/state_hold.hpp"

namespace quadrat::kiosk::commands {
namespace {

struct Options {
    std::string state;
    int version = 0;
};

int move(const Options& options) {
    const auto folder = tended_state_folder(options.state);
    std::error_code error;
    if (!std::filesystem::exists(folder / exhibit::kStateFile, error))
        throw base::InputError(fmt::format("{}: there is no state file; name its folder with --state",
                                           (folder / exhibit::kStateFile).string()));
    const auto lock = hold_state(folder, "quadrat state --move-to");
    const int before = exhibit::move_state(folder, options.version);
    std::printf("the state file is of version %d now; it was of version %d\n", options.version, before);
    return 0;
}

}  // namespace

void add_state(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "state",
        "Move the state file to another schema version, so that an older program can go on with it. A newer program "
        "moves an older file by itself. Stop the exhibit first: systemctl stop quadrat");
    command->add_option("--state", options->state, "Folder of what is kept between runs");
    command->add_option("--move-to", options->version, "The version, 1 to " + std::to_string(exhibit::state_version()))
        ->required();
    command->callback([options, &chosen] { chosen = [options] { return move(*options); }; });
}

}  // namespace quadrat::kiosk::commands
