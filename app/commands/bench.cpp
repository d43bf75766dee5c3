// SPDX-License-Identifier: Apache-2.0
#include <fmt/chrono.h>

#include <algorithm>
#include <ctime>
#include <iostream>
#include <memory>
#include <optional>

#include "base/file.hpp"
#include "base/text_file.hpp"
#include "benches/benches.hpp"
#include "benches/report.hpp"
#include "commands/commands.hpp"
#include "display/display.hpp"
#include "machine/version.hpp"
#include "pictures/picture.hpp"

namespace quadrat::commands {
namespace {

using benches::Results;

struct Options {
    std::vector<std::string> groups{"all"};
    bool is_json = false;
    std::string plot;     // FILE.svg of a visit's frames; may be empty
    std::string report;   // FILE.html; may be empty
    std::string shaders;  // FILE.json that tests/gpu/run wrote, for the report; may be empty
    std::string peers;    // FILE.json that bench_peers wrote, for the report; may be empty
    benches::Options how;
};

struct Group {
    const char* name;
    void (*measure)(benches::Results& results, const benches::Options& how);
};

// Frames first: the peak of memory is then the exhibit's and not that of a group before it.
constexpr Group kGroups[] = {
    {"frame", benches::frame},
    {"generation", [](benches::Results& results, const benches::Options&) { benches::generation(results); }},
    {"trees", [](benches::Results& results, const benches::Options&) { benches::trees(results); }},
    {"land", [](benches::Results& results, const benches::Options&) { benches::land(results); }},
    {"sky", [](benches::Results& results, const benches::Options&) { benches::sky(results); }},
    {"breeding", [](benches::Results& results, const benches::Options&) { benches::breeding(results); }},
    {"detail", benches::detail},
    {"fidelity", benches::fidelity},
    {"start", benches::start},
    {"worth", [](benches::Results& results, const benches::Options&) { benches::worth(results); }},
    {"visit", benches::visit}};

std::vector<std::string> group_names() {
    std::vector<std::string> names;
    for (const Group& group : kGroups) names.emplace_back(group.name);
    return names;
}

bool is_asked(const Group& group, const std::vector<std::string>& groups) {
    const auto holds = [&](std::string_view name) { return std::ranges::find(groups, name) != groups.end(); };
    return holds(group.name) || (holds("all") && group.name != std::string_view("visit"));
}

// What is shown beside what is measured here.
struct Beside {
    std::optional<benches::ShaderTable> shaders;
    std::optional<benches::PeerTable> peers;
};

// Asks for what would otherwise be found after minutes of measuring.
Beside checked(const Options& options) {
    constexpr std::size_t kLimit_bytes = 4U << 20U;
    const auto text_of = [](const std::string& file) { return base::read_text(file, {kLimit_bytes, kLimit_bytes}); };
    display::size_from(options.how.size, "--size");
    if (!options.plot.empty()) base::require_ending(options.plot, {".svg"}, "a plot");
    if (!options.report.empty()) base::require_ending(options.report, {".html", ".htm"}, "a report");
    Beside beside;
    if (!options.shaders.empty())
        beside.shaders = benches::shader_table_from(text_of(options.shaders), options.shaders);
    if (!options.peers.empty()) beside.peers = benches::peer_table_from(text_of(options.peers), options.peers);
    return beside;
}

std::string now_as_text() { return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr))); }

void print(const benches::Results& results, bool is_json) {
    if (is_json)
        std::cout << json_of(results.figures, results.gpu) << std::endl;
    else
        std::cout << machine::machine_description() << (results.gpu.empty() ? "" : "; " + results.gpu) << "\n\n"
                  << machine::table_of(results.figures) << std::flush;
}

int bench(const Options& options) {
    const Beside beside = checked(options);
    benches::Report report{machine::machine_description(),
                           std::string(machine::version()),
                           now_as_text(),
                           {},
                           {},
                           {},
                           beside.shaders,
                           beside.peers};
    benches::Results& results = report.results;
    for (const Group& group : kGroups) {
        if (!is_asked(group, options.groups)) continue;
        std::cerr << "measuring " << group.name << " …\n";
        report.groups.emplace_back(group.name);
        group.measure(results, options.how);
    }
    report.settings = benches::settings_of(options.how, report.groups);
    // First where nothing can go wrong any more: a disk may have filled up meanwhile.
    print(results, options.is_json);
    if (!options.plot.empty() && !results.visit_svg.empty()) base::write_file(options.plot, results.visit_svg);
    if (!options.report.empty()) base::write_file(options.report, benches::html_of(report));
    return 0;
}

}  // namespace

void add_bench(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand("bench", "Measure this machine: growing, frames, memory");
    std::vector<std::string> names = group_names();
    names.emplace_back("all");
    command
        .add_option("group", options->groups, "Groups. all: every one but visit, which is measured where it is named")
        .among(names)
        .shows_default();
    command.add_flag("--json", options->is_json, "One JSON object instead of a table");
    command.add_option("--size", options->how.size, "Pixels of the frames").shows_default();
    command.add_option("--frames", options->how.frames, "How many are timed").between(1, 100000).shows_default();
    command.add_option("--alpha", options->how.alpha, "Detail: 1 is standard").between(0.01F, 100.0F).shows_default();
    command
        .add_option("--triangles", options->how.triangles, "frame, fidelity, a profile: no more than so many a frame")
        .tells_default("no limit");
    command.add_option("--ground", options->how.ground, "frame, fidelity: what draws the land, blocks or roam")
        .among(render::ground_names())
        .shows_default();
    command.add_option("--pixels", options->how.pixels, "The same for the pixels of the views")
        .tells_default("no limit");
    command.add_option("--profile", options->how.profile, "detail: what a frame would take on this machine, estimated")
        .among({"pi4", "pi5"})
        .tells_default("none");
    command.add_option("--minutes", options->how.minutes, "visit: how long is played")
        .between(0.1, 600.0)
        .shows_default();
    command.add_option("--hz", options->how.hz, "visit: of the screen").between(1.0, 240.0).shows_default();
    command.add_option("--then-hz", options->how.then_hz, "visit: of the screen in the last third")
        .between(1.0, 240.0)
        .tells_default("the same");
    command.add_flag("--busy", options->how.is_busy,
                     "visit: something else takes a core, and time from uploads, for the middle third");
    command
        .add_option("--attended", options->how.attended,
                    "visit: the state folder of a desk, which looks at the visit as at an exhibit's")
        .is_folder()
        .tells_default("nobody looks");
    command.add_option("--plot", options->plot, "visit: FILE.svg of the frames and what the governor did")
        .tells_default("none");
    const Option report = command
                              .add_option("--report", options->report,
                                          "FILE.html with all of it: machine, settings, tables, the plot of a visit")
                              .tells_default("none");
    command
        .add_option("--shaders", options->shaders,
                    "For the report: FILE.json of what shaders need on a Raspberry Pi, from tests/gpu/run --json")
        .needs(report)
        .tells_default("none");
    command
        .add_option("--peers", options->peers,
                    "For the report: FILE.json of ratios to what others need, from bench_peers --json")
        .needs(report)
        .tells_default("none");
    command.does([options] { return bench(*options); });
}

}  // namespace quadrat::commands
