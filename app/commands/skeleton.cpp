// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text_file.hpp"
#include "commands/commands.hpp"
#include "commands/plan_json.hpp"
#include "mesh/model.hpp"
#include "mesh/roof_mesh.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string plan;
    std::string output = "-";
};

int roof_over(const Options& options) {
    const bool is_printed = options.output == "-";
    if (!is_printed) base::require_ending(options.output, {".json", ".svg", ".obj", ".glb", ".gltf"}, "a roof");
    const PlanFile file = plan_from(base::read_text(options.plan, base::kJsonLimits), options.plan);
    mesh::Roof roof;
    try {
        roof = mesh::straight_skeleton(file.plan, file.options);
    } catch (const mesh::PlanError& error) {
        throw base::InputError(fmt::format("{}: {}", options.plan, error.what()));
    }
    const std::string ending = is_printed ? ".json" : base::ending_of(options.output);
    std::string bytes;
    if (ending == ".json") bytes = json_of(roof);
    if (ending == ".svg") bytes = svg_of(roof);
    if (bytes.empty()) {
        mesh::Model model;
        model.parts.push_back({"roof", mesh::roof_mesh(roof), {0.5F, 0.2F, 0.12F}});
        if (!roof.tops.empty()) model.parts.push_back({"top", mesh::top_mesh(roof), {0.6F, 0.55F, 0.45F}});
        bytes = mesh::model_file(model, ending);
    }
    base::print_or_write_file(options.output, bytes);
    return 0;
}

}  // namespace

void add_skeleton(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand("skeleton", "Roof a polygon by its weighted straight skeleton");
    command
        .add_option(
            "plan", options->plan,
            "JSON, metres: {\"outer\": [[x, y], …], \"holes\": […], \"weights\": [slope of each edge, degrees], "
            "\"profiles\": {\"all\": [{\"slope\": 90}, {\"from\": 3, \"slope\": 40}]}, \"height\": end, "
            "\"ambiguity\": \"least\"}; all but outer may be left out")
        .required();
    command
        .add_option("-o,--output", options->output, "NAME.json, .svg, .obj, .glb or .gltf; -: JSON on standard output")
        .shows_default();
    command.does([options] { return roof_over(*options); });
}

}  // namespace quadrat::commands
