// SPDX-License-Identifier: Apache-2.0
// bin/bench_peers: the table of ratios.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>

#include "base/log.hpp"
#include "bench/peers/peers.hpp"
#include "display/display.hpp"
#include "machine/measurement.hpp"

namespace quadrat::peers {
namespace {

struct Group {
    std::vector<std::string> names;
    std::vector<Row> (*measure)(const Options& how);
};

const std::vector<Group>& groups() {
    static const std::vector<Group> kGroups{
        {{"chain", "chain_cgal"}, chain},
        {{"fbm", "fbm_plain"}, fbm},
        {{"skeleton"}, skeleton},
        {{"land_pass", "sky_pass"}, passes},
        {{"frame_alpha_1", "frame_alpha_02", "memory", "first_frame", "generation"},
         [](const Options& how) { return whole(how, std::filesystem::read_symlink("/proc/self/exe")); }}};
    return kGroups;
}

std::vector<std::string> all_names() {
    std::vector<std::string> names;
    for (const Group& group : groups()) names.insert(names.end(), group.names.begin(), group.names.end());
    return names;
}

std::vector<Row> measured(const Options& how) {
    const auto asked = [&](const std::string& name) { return is_asked(how, name); };
    std::vector<Row> rows;
    for (const Group& group : groups()) {
        std::vector<std::string> names;
        std::ranges::copy_if(group.names, std::back_inserter(names), asked);
        if (names.empty()) continue;
        std::cerr << fmt::format("measuring {} …\n", fmt::join(names, ", "));
        for (Row& row : group.measure(how))
            if (asked(row.name)) rows.push_back(std::move(row));
    }
    return rows;
}

int run(int argc, char** argv) {
    CLI::App app(
        "Measures ours beside what others need for the same, in turns: meshoptimizer, CGAL, libnoise, plain code, "
        "and Chromium with three.js. A ratio is ours to the yardstick's, the median of the turns'; its spread is "
        "from their first to their third quartile.");
    Options how;
    bool is_json = false;
    bool shows_four = false;
    app.add_option("--only", how.rows, "Rows to measure, instead of all")->check(CLI::IsMember(all_names()));
    app.add_option("--turns", how.turns, "How often each is measured")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--size", how.size, "Pixels of the frames")->capture_default_str();
    app.add_option("--folder", how.folder, "Where the landscapes for Chromium are kept, to look at");
    app.add_flag("--as-exported", how.is_as_exported,
                 "Give Chromium what quadrat export writes, without the coarser levels that a page draws from afar");
    app.add_flag("--quick", how.is_quick, "Less of everything: to see that it works");
    app.add_flag("--json", is_json, "One JSON object instead of a table");
    app.add_flag("--four-views", shows_four,
                 "What it starts itself for our turns beside Chromium: prints their figures");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    base::open_log(base::LogDetail::Quiet);
    display::size_from(how.size, "--size");  // now, rather than after minutes
    if (shows_four) {
        std::cout << four_views(how) << std::endl;
        return 0;
    }
    const std::vector<Row> rows = measured(how);
    const std::string machine = machine::machine_description();
    std::cout << (is_json ? json_of(machine, rows) + "\n" : table_of(machine, rows)) << std::flush;
    return std::cout ? 0 : 1;
}

}  // namespace

bool is_asked(const Options& how, std::string_view row) {
    return how.rows.empty() || std::ranges::find(how.rows, row) != how.rows.end();
}

}  // namespace quadrat::peers

int main(int argc, char** argv) {
    try {
        return quadrat::peers::run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "bench_peers: " << error.what() << '\n';
        return 2;
    }
}
