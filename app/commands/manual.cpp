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

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
    std::vector<const CLI::App*> all{&program};
    for (const CLI::App* one : program.get_subcommands([](const CLI::App*) { return true; })) all.push_back(one);
    return all;
}

int write_pages(const CLI::App& program, const Options& options) {
    if (!std::filesystem::is_directory(options.folder))
        throw base::InputError(fmt::format("--all {}: there is no such folder", options.folder));
    for (const CLI::App* one : commands_of(program))
        base::write_file(std::filesystem::path(options.folder) / (page_name(*one) + ".1"), man_page(*one));
    return 0;
}

int show_page(const CLI::App& program, const Options& options) {
    if (!options.folder.empty()) return write_pages(program, options);
    for (const CLI::App* one : commands_of(program)) {
        if (one->get_name() != (options.command.empty() ? program.get_name() : options.command)) continue;
        std::fputs(man_page(*one).c_str(), stdout);
        return 0;
    }
    throw base::InputError(fmt::format("man: {} is not a subcommand; see quadrat --help", options.command));
}

}  // namespace

void add_man(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("man", "A manual page, to be read with: quadrat man run | man -l -");
    command->add_option("command", options->command, "Of which subcommand")->default_str("of quadrat itself");
    command->add_option("--all", options->folder, "Instead, every page into this folder")->default_str("none");
    command->callback([options, &app, &chosen] { chosen = [options, &app] { return show_page(app, *options); }; });
}

void add_completion(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("completion", "What a shell completes commands with: . <(quadrat completion bash)");
    command->add_option("shell", options->shell, "bash")->check(CLI::IsMember({"bash"}))->required();
    command->callback([options, &app, &chosen] {
        chosen = [&app] {
            std::fputs(bash_completion(app).c_str(), stdout);
            return 0;
        };
    });
}

}  // namespace quadrat::commands
