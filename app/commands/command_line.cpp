// SPDX-License-Identifier: Apache-2.0
#include "commands/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>

#include "base/error.hpp"
#include "base/log.hpp"
#include "base/standard_streams.hpp"
#include "commands/commands.hpp"
#include "machine/version.hpp"

namespace quadrat::commands {
namespace {

constexpr int kBadUsage = 2;

std::vector<std::string> subcommands_of(CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

// A line for each thing that is wrong.
int refuse(const std::string& what) {
    std::size_t begin = 0;
    for (std::size_t end = what.find('\n'); end != std::string::npos; end = what.find('\n', begin = end + 1))
        std::fprintf(stderr, "quadrat: %s\n", what.substr(begin, end - begin).c_str());
    std::fprintf(stderr, "quadrat: %s\n", what.substr(begin).c_str());
    return kBadUsage;
}

// The innermost subcommand that was named: "quadrat words sheet".
std::string innermost(const CLI::App& app) {
    std::string words = app.get_name();
    const CLI::App* at = &app;
    for (auto below = at->get_subcommands(); !below.empty(); below = at->get_subcommands()) {
        at = below.back();
        words += " " + at->get_name();
    }
    return words;
}

int parse_and_act(int argc, const char* const* argv) {
    CLI::App app{"Quadrat: an unattended exhibit that breeds landscapes from button presses", "quadrat"};
    app.require_subcommand(1);
    app.set_version_flag("--version", "quadrat " + std::string(machine::version()));
    bool is_quiet = false;
    bool is_verbose = false;
    app.add_flag("-q,--quiet", is_quiet, "Log warnings and errors only");
    app.add_flag("-v,--verbose", is_verbose, "Log everything");
    Action chosen;
    add_all(app, chosen);
    // CLI11 would call a misspelt subcommand a missing one.
    const std::vector<std::string> known = subcommands_of(app);
    if (argc > 1 && argv[1][0] != '-' && std::ranges::find(known, argv[1]) == known.end())
        return refuse(fmt::format("{} is not a subcommand; there are {}", argv[1], fmt::join(known, ", ")));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
        return refuse(fmt::format("{} (see {} --help)", error.what(), innermost(app)).c_str());
    }
    try {
        base::open_log(is_quiet     ? base::LogDetail::Quiet
                       : is_verbose ? base::LogDetail::Verbose
                                    : base::LogDetail::Normal);
        return chosen();
    } catch (const base::InputError& error) {
        return refuse(error.what());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "quadrat: unexpected: %s\n", error.what());
        return 1;
    }
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
    base::hold_standard_streams();
    const int status = parse_and_act(argc, argv);
    return base::is_standard_output_written() || status != 0 ? status : 1;
}

}  // namespace quadrat::commands
