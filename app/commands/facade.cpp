// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/markup.hpp"
#include "base/text_file.hpp"
#include "commands/commands.hpp"
#include "mesh/model.hpp"
#include "synthesis/houses/facade.hpp"

namespace quadrat::commands {
namespace {

using namespace synthesis::houses;

struct Options {
    std::string grammar;
    std::string output;
    FacadeShape shape;
    std::vector<double> beside;
    std::uint64_t seed = 1;
    bool is_listing = false;
};

FacadeGrammar grammar_from(const std::string& name) {
    if (std::filesystem::exists(name)) return read_facade(base::read_text(name), name);
    for (const NamedFacade& one : facade_library())
        if (one.name == name) return read_facade(one.text, name);
    throw base::InputError(
        fmt::format("{}: there is no such file; quadrat facade --list names the house types that come along", name));
}

std::string hex_of(glm::vec3 colour) {
    const auto part = [](float c) { return static_cast<int>(std::clamp(255.0F * c + 0.5F, 0.0F, 255.0F)); };
    return fmt::format("#{:02x}{:02x}{:02x}", part(colour.r), part(colour.g), part(colour.b));
}

// From the front. What stands out casts a shadow below and to the right, what lies back has one within.
std::string svg_of(const std::vector<FacadePanel>& panels, const FacadeShape& shape, const std::string& name) {
    const double scale = 900 / std::max(shape.width_m, shape.height_m + shape.gable_m);
    const double top = shape.height_m + shape.gable_m;
    const auto rectangle = [&](glm::dvec2 low, glm::dvec2 high, const std::string& paint) {
        return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" {}/>\n",
                           30 + scale * low.x, 30 + scale * (top - high.y), scale * (high.x - low.x),
                           scale * (high.y - low.y), paint);
    };
    const auto corner = [&](double x, double y) {
        return fmt::format("{:.2f},{:.2f} ", 30 + scale * x, 30 + scale * (top - y));
    };
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\">\n<title>{}</title>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#cfdbe2\"/>\n<clipPath id=\"wall\"><polygon "
        "points=\"{}\"/></clipPath>\n"
        "<g clip-path=\"url(#wall)\">\n",
        60 + scale * shape.width_m, 60 + scale * top, base::escaped(name),
        corner(0, 0) + corner(shape.width_m, 0) + corner(shape.width_m, shape.height_m) +
            corner(0.5 * shape.width_m, top) + corner(0, shape.height_m));
    for (const FacadePanel& panel : panels) {
        const double out = panel.depth_m - panel.depth_from_m;
        const glm::dvec2 shade(0.35 * out, -0.5 * out);
        const std::string dark = "fill=\"#000\" fill-opacity=\"0.28\"";
        if (out > 0) svg += rectangle(panel.low_m + shade, panel.high_m + shade, dark);
        svg += rectangle(panel.low_m, panel.high_m, fmt::format("fill=\"{}\"", hex_of(panel.colour)));
        if (out < 0) {
            const glm::dvec2 size = panel.high_m - panel.low_m;
            svg += rectangle({panel.low_m.x, panel.high_m.y + std::max(0.5 * out, -size.y)}, panel.high_m, dark);
            svg += rectangle(panel.low_m, {panel.low_m.x + std::min(-0.35 * out, size.x), panel.high_m.y}, dark);
        }
    }
    for (const FacadeShape::Covered& covered : shape.covered)
        svg += rectangle(covered.low_m, covered.high_m, "fill=\"#9aa3a4\"");
    return svg + "</g>\n</svg>\n";
}

int draw(Options options) {
    if (options.is_listing) {
        for (const NamedFacade& one : facade_library())
            fmt::print("{:<14} {}\n", one.name, read_facade(one.text, one.name).name);
        return 0;
    }
    if (options.grammar.empty())
        throw base::InputError("facade: name a grammar: a file, or one of quadrat facade --list");
    if (options.output.empty()) throw base::InputError("facade: -o names what to write, NAME.svg, .obj, .glb or .gltf");
    base::require_ending(options.output, {".svg", ".obj", ".glb", ".gltf"}, "a façade");
    if (!options.beside.empty()) options.shape.covered.push_back({{0, 0}, {options.beside[0], options.beside[1]}});
    const FacadeGrammar grammar = grammar_from(options.grammar);
    const std::vector<FacadePanel> panels = derive_facade(grammar, options.shape, base::Seed{options.seed});
    if (panels.empty())
        throw base::InputError(fmt::format("{}: it draws nothing: no panel comes of it", options.grammar));
    const std::string ending = base::ending_of(options.output);
    if (ending == ".svg") {
        base::write_file(options.output,
                         svg_of(panels, options.shape, grammar.name.empty() ? options.grammar : grammar.name));
        return 0;
    }
    const mesh::Model model = facade_model(panels);
    base::write_file(options.output, mesh::model_file(model, ending));
    return 0;
}

}  // namespace

void add_facade(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command =
        program.add_subcommand("facade", "Derive a house's front by a split grammar and draw or mesh it");
    command.add_option("grammar", options->grammar, "A grammar file, or the name of a house type that comes along")
        .tells_default("none: needed unless --list is");
    command.add_option("-o,--output", options->output, "NAME.svg, .obj, .glb or .gltf")
        .tells_default("none: needed unless --list is");
    command.add_option("--width", options->shape.width_m, "Metres").between(0.5, 200.0).shows_default();
    command.add_option("--height", options->shape.height_m, "To the eaves, metres").between(0.5, 200.0).shows_default();
    command.add_option("--gable", options->shape.gable_m, "Height of a gable above them, metres")
        .between(0.0, 100.0)
        .shows_default();
    command.add_option("--beside", options->beside, "A neighbour on the left covers WIDTH and HEIGHT of it, metres")
        .takes(2)
        .tells_default("none");
    command.add_option("--seed", options->seed, "Of what the grammar leaves to chance").shows_default();
    command.add_flag("--list", options->is_listing, "Name the house types that come along");
    command.does([options] { return draw(*options); });
}

}  // namespace quadrat::commands
