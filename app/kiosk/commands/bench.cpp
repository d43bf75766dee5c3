// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>
#include <memory>

#include "kiosk/benches/benches.hpp"
#include "kiosk/commands/commands.hpp"

namespace quadrat::kiosk::commands {
namespace {

struct Options {
    std::string group = "all";
    bool is_json = false;
    benches::Options how;
};

struct Group {
    std::string name;
    std::function<void(benches::Results&)> measure;
};

int bench(const Options& options) {
    std::string gpu;
    // Frames first: the peak of memory is then the exhibit's and not that of a group before it.
    const std::vector<Group> groups{{"frame", [&](auto& results) { benches::frame(results, options.how, gpu); }},
                                    {"generation", benches::generation},
                                    {"trees", benches::trees},
                                    {"land", benches::land},
                                    {"sky", benches::sky},
                                    {"breeding", benches::breeding},
                                    {"detail", [&](auto& results) { benches::detail(results, options.how); }},
                                    {"fidelity", [&](auto& results) { benches::fidelity(results, options.how); }},
                                    {"start", [&](auto& results) { benches::start(results, options.how); }},
                                    {"visit", [&](auto& results) { benches::visit(results, options.how); }}};
    benches::Results results;
    for (const Group& group : groups) {
        const bool is_asked = options.group == group.name || (options.group == "all" && group.name != "visit");
        if (!is_asked) continue;
        std::cerr << "measuring " << group.name << " …\n";
        group.measure(results);
    }
    if (options.is_json)
        std::cout << json_of(results, gpu) << '\n';
    else
        std::cout << machine_description() << (gpu.empty() ? "" : "; " + gpu) << "\n\n" << table_of(results);
    return 0;
}

}  // namespace

void add_bench(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("bench", "Measure this machine: growing, frames, memory");
    command
        ->add_option("group", options->group,
                     "all, frame, generation, trees, land, sky, breeding, detail, fidelity, start; or visit, which is "
                     "not among all")
        ->check(CLI::IsMember(
            {"all", "frame", "generation", "trees", "land", "sky", "breeding", "detail", "fidelity", "start", "visit"}))
        ->capture_default_str();
    command->add_flag("--json", options->is_json, "One JSON object instead of a table");
    command->add_option("--size", options->how.size, "Pixels of the frames")->capture_default_str();
    command->add_option("--frames", options->how.frames, "How many are timed")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--alpha", options->how.alpha, "Detail: 1 is standard")
        ->check(CLI::Range(0.01F, 100.0F))
        ->capture_default_str();
    command->add_option("--triangles", options->how.triangles,
                        "frame, fidelity, a profile: no more than so many a frame");
    command->add_option("--pixels", options->how.pixels, "The same for the pixels of the views");
    command->add_option("--profile", options->how.profile, "detail: what a frame would take on this machine, estimated")
        ->check(CLI::IsMember({"pi4", "pi5"}));
    command->add_option("--minutes", options->how.minutes, "visit: how long is played")
        ->check(CLI::Range(0.1, 600.0))
        ->capture_default_str();
    command->add_option("--hz", options->how.hz, "visit: of the screen")
        ->check(CLI::Range(1.0, 240.0))
        ->capture_default_str();
    command->add_option("--then-hz", options->how.then_hz, "visit: of the screen in the last third")
        ->check(CLI::Range(1.0, 240.0));
    command->add_flag("--busy", options->how.is_busy,
                      "visit: something else takes a core, and time from uploads, for the middle third");
    command->add_option("--plot", options->how.plot, "visit: FILE.svg of the frames and what the governor did");
    command->callback([options, &chosen] { chosen = [options] { return bench(*options); }; });
}

}  // namespace quadrat::kiosk::commands
