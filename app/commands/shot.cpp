// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>

#include "base/error.hpp"
#include "base/file.hpp"
#include "commands/ask_exhibit.hpp"
#include "commands/commands.hpp"
#include "site/state_folder.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::string output;
    std::string state;
};

int shoot(const Options& options) {
    base::require_ending(options.output, {".png"}, "a shot");
    const fs::path folder = site::watched_folder(options.state);
    base::write_file(options.output, picture_of_exhibit(folder));
    std::printf("%s\n", fs::absolute(options.output).lexically_normal().c_str());
    return 0;
}

}  // namespace

void add_shot(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command =
        program.add_subcommand("shot", "A picture of what a running exhibit shows just now, as PNG");
    command.add_option("-o,--output", options->output, "Where to: NAME.png").required();
    command.add_option("--state", options->state, "The exhibit's state folder, when it is not the service")
        .tells_default("the service's");
    command.does([options] { return shoot(*options); });
}

}  // namespace quadrat::commands
