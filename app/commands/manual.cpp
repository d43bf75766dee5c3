// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "base/error.hpp"
#include "base/file.hpp"
#include "commands/commands.hpp"
#include "commands/manual_pages.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string command;
    std::string folder;
    std::string shell;
};

int write_pages(const std::vector<ManualPage>& pages, const std::string& folder) {
    if (!std::filesystem::is_directory(folder))
        throw base::InputError(fmt::format("--all {}: there is no such folder", folder));
    for (const ManualPage& page : pages)
        base::write_file(std::filesystem::path(folder) / (page.name + ".1"), page.text);
    return 0;
}

int show_page(const Command& program, const Options& options) {
    const std::vector<ManualPage> pages = manual_pages(program.app());
    if (!options.folder.empty()) return write_pages(pages, options.folder);
    for (const ManualPage& page : pages) {
        if (page.command != (options.command.empty() ? pages.front().command : options.command)) continue;
        std::fputs(page.text.c_str(), stdout);
        return 0;
    }
    throw base::InputError(fmt::format("man: {} is not a subcommand; see quadrat --help", options.command));
}

}  // namespace

void add_man(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand("man", "A manual page, to be read with: quadrat man run | man -l -");
    command.add_option("command", options->command, "Of which subcommand").tells_default("of quadrat itself");
    command.add_option("--all", options->folder, "Instead, every page into this folder").tells_default("none");
    command.does([options, program] { return show_page(program, *options); });
}

void add_completion(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command =
        program.add_subcommand("completion", "What a shell completes commands with: . <(quadrat completion bash)");
    command.add_option("shell", options->shell, "bash").among({"bash"}).required();
    command.does([program] {
        std::fputs(bash_completion(program.app()).c_str(), stdout);
        return 0;
    });
}

}  // namespace quadrat::commands
