// SPDX-License-Identifier: Apache-2.0
#include "report/counts.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "base/error.hpp"
#include "base/file.hpp"
#include "commands/commands.hpp"
#include "commands/visits.hpp"
#include "report/writers.hpp"
#include "site/hours.hpp"
#include "site/state_folder.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string state, from, to, output;
    std::string title = "Visitors of the exhibit";
};

std::optional<report::Date> date_of(const std::string& text, const char* option) {
    if (text.empty()) return std::nullopt;
    try {
        return site::parse_date(text);
    } catch (const std::invalid_argument& error) {
        throw base::InputError(fmt::format("{}: {}", option, error.what()));
    }
}

int tell(const Options& options) {
    const report::Days days{date_of(options.from, "--from"), date_of(options.to, "--to")};
    if (days.from && days.to && *days.from > *days.to)
        throw base::InputError(fmt::format("--from {} is after --to {}", options.from, options.to));
    const bool is_for_people = options.output.empty();
    const bool is_printed = options.output == "-";
    if (!is_for_people && !is_printed)
        base::require_ending(options.output, {".html", ".htm", ".csv", ".json"}, "a report of visits");
    const std::filesystem::path folder = site::tended_state_folder(options.state);
    const report::Counts counts = count_visits(folder, days);
    if (is_for_people) {
        std::fputs(report::text_of(counts).c_str(), stdout);
        return 0;
    }
    const report::Heading heading = heading_of(options.title);
    const std::string ending = is_printed ? ".json" : base::ending_of(options.output);
    base::print_or_write_file(options.output, ending == ".json"  ? report::json_of(counts, heading)
                                              : ending == ".csv" ? report::csv_of(counts)
                                                                 : report::html_of(counts, heading));
    return 0;
}

}  // namespace

void add_report(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand(
        "report",
        "What visitors did, from the state file, also while the exhibit runs: how many came when, how long they "
        "stayed,\n"
        "where they left, what they answered. Without -o a few lines. Nothing in it tells who a visitor was");
    command
        .add_option("--state", options->state,
                    "Folder of what is kept between runs; without it, the service's where it is installed")
        .tells_default("the service's, else ~/.local/state/quadrat");
    command.add_option("--from", options->from, "First day, as 2026-11-26").tells_default("the first that is kept");
    command.add_option("--to", options->to, "Last day, itself included").tells_default("the last that is kept");
    command
        .add_option("-o,--output", options->output,
                    "NAME.html: a page with plots, to read or print; .csv: a row a day; .json: all counts; -: JSON on "
                    "standard output")
        .tells_default("a few lines on standard output");
    command.add_option("--title", options->title, "Of the page").shows_default();
    command.does([options] { return tell(*options); });
}

}  // namespace quadrat::commands
