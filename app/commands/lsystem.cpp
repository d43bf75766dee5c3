// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/markup.hpp"
#include "base/text_file.hpp"
#include "commands/commands.hpp"
#include "commands/map_drawing.hpp"
#include "mesh/model.hpp"
#include "synthesis/trees/grammar.hpp"
#include "synthesis/trees/limb_mesh.hpp"
#include "synthesis/trees/turtle.hpp"

namespace quadrat::commands {
namespace {

using namespace synthesis::trees;

struct Options {
    std::string grammar;
    std::string output;
    std::string limbs = "swept";
    int steps = -1;
    std::uint64_t seed = 1;
    std::size_t most_symbols = 4U << 20U;
    float chance = 0;
    int pull = 0;
    bool is_listing = false;
};

Grammar grammar_from(const std::string& name) {
    if (std::filesystem::exists(name)) return read_grammar(base::read_text(name), name);
    const auto& library = grammar_library();
    const bool is_known = std::ranges::find(library, name, &NamedGrammar::name) != library.end();
    if (!is_known && name.find_first_of("./") != std::string::npos)
        throw base::InputError(
            fmt::format("{}: there is no such file; quadrat lsystem --list names the grammars that come along", name));
    return library_grammar(name);
}

// Widths in proportion to the whole: a grammar says how they taper, not how thick a line is in its unit.
TreeSkeleton skeleton_of(const Grammar& grammar, const Word& word, base::Seed seed) {
    TurtleOptions options = options_of(grammar);
    float widest = 1.0e-6F;
    for (const Word::Symbol& symbol : word.symbols)
        if (symbol.letter == '!' && symbol.arguments > 0) widest = std::max(widest, word.values[symbol.first]);
    const bool has_widths = widest > 1.0e-5F;
    options.radius_per_width = 1.0e-4F;
    options.least_radius_m = 1.0e-7F;
    TreeSkeleton skeleton = interpret(word, options, seed);
    const glm::vec3 size = skeleton.high_m - skeleton.low_m;
    const float reach = std::max({size.x, size.y, size.z, 1.0e-3F});
    const float thickest = has_widths ? 0.016F * reach : 0.002F * reach;
    const float factor = thickest / (1.0e-4F * (has_widths ? widest : std::max(grammar.width, 1.0e-6F)));
    for (Limb& limb : skeleton.limbs)
        for (Limb::Node& node : limb.nodes) node.radius_m = std::max(node.radius_m * factor, 3.0e-4F * reach);
    measure(skeleton);
    return skeleton;
}

// Seen from the front, a line a limb's internode and a drop a leaf.
std::string svg_of(const TreeSkeleton& skeleton, const std::string& name) {
    constexpr float kSide = 1000;
    const glm::vec3 size = skeleton.high_m - skeleton.low_m;
    const float scale = 0.92F * kSide / std::max({size.x, size.y, 1.0e-3F});
    const float width = std::max(scale * size.x + 0.08F * kSide, 0.2F * kSide);
    const float height = std::max(scale * size.y + 0.08F * kSide, 0.2F * kSide);
    const auto x = [&](const glm::vec3& p) {
        return 0.5F * width + scale * (p.x - 0.5F * (skeleton.low_m.x + skeleton.high_m.x));
    };
    const auto y = [&](const glm::vec3& p) { return height - 0.04F * kSide - scale * (p.y - skeleton.low_m.y); };
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\">\n<title>{}</title>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#f6f3ea\"/>\n<g stroke=\"#4a3a2c\" stroke-linecap=\"round\">\n",
        width, height, base::escaped(name));
    for (const Limb& limb : skeleton.limbs)
        for (std::size_t i = 1; i < limb.nodes.size(); ++i) {
            const auto& a = limb.nodes[i - 1];
            const auto& b = limb.nodes[i];
            svg += fmt::format(
                "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke-width=\"{:.2f}\"/>\n", x(a.at_m),
                y(a.at_m), x(b.at_m), y(b.at_m), std::max(scale * (a.radius_m + b.radius_m), 0.6F));
        }
    svg += "</g>\n<g fill=\"#5c8a3e\">\n";
    for (const Site& site : skeleton.sites)
        svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"{}\"/>\n", x(site.at_m), y(site.at_m),
                           site.organ == Organ::Flower ? 5 : 3, site.organ == Organ::Flower ? "#d06a72" : "#5c8a3e");
    return svg + "</g>\n</svg>\n";
}

mesh::Model model_of(const TreeSkeleton& skeleton, const std::string& limbs) {
    scene::Wood wood;
    if (limbs == "swept") wood = sweep_tubes(skeleton, {});
    if (limbs == "cylinders") wood = mesh_cylinders(skeleton, 8);
    if (limbs == "smooth") {
        const glm::vec3 size = skeleton.high_m - skeleton.low_m;
        MetaTubeDetail detail;
        detail.cell_m = std::max({size.x, size.y, size.z, 1.0e-3F}) / 256;
        detail.sweeps_twigs = false;
        wood = mesh_meta_tubes(skeleton, detail);
    }
    mesh::Model model;
    model.parts.push_back({"wood", std::move(wood.mesh), {0.2F, 0.14F, 0.09F}});
    return model;
}

// A rule that waits for what never comes looks like a fault of the program.
void warn_of_contexts(const Grammar& grammar, const std::string& source) {
    for (const Production* p : contexts_in_vain(grammar))
        fmt::print(stderr, "{}:{}: {} can never apply: no word of this grammar has that context{}\n", source, p->line,
                   p->text,
                   grammar.outside == 0 ? "; contexts see nothing beyond an axis's ends unless the grammar says so, as "
                                          "in outside: 0"
                                        : "");
}

int list() {
    for (const NamedGrammar& one : grammar_library())
        fmt::print("{:<12} {}\n", one.name, library_grammar(one.name).name);
    for (const synthesis::lsystem::NamedMap& one : synthesis::lsystem::map_library())
        fmt::print("{:<12} {}\n", one.name, synthesis::lsystem::library_map(one.name).name);
    return 0;
}

int derive_and_draw_map(const Options& options) {
    if (!options.output.empty()) base::require_ending(options.output, {".txt", ".svg"}, "a map of cells");
    const synthesis::lsystem::MapGrammar grammar = map_grammar_from(options.grammar);
    const synthesis::lsystem::Map map = derived_from_polygon(
        grammar, {.steps = options.steps, .chance = options.chance, .pull = options.pull}, base::Seed{options.seed});
    if (base::ending_of(options.output) == ".svg")
        base::write_file(options.output, svg_of_map(map, grammar.name.empty() ? options.grammar : grammar.name));
    else
        base::print_or_write_file(options.output.empty() ? "-" : options.output, text_of_map(map));
    return 0;
}

int derive_and_draw(const Options& options) {
    if (options.is_listing) return list();
    if (options.grammar.empty())
        throw base::InputError("lsystem: name a grammar: a file, or one of quadrat lsystem --list");
    if (names_a_map(options.grammar)) return derive_and_draw_map(options);
    if (options.chance > 0 || options.pull > 0)
        throw base::InputError("--chance and --pull are of maps of cells, grammars that begin with map:");
    const std::string ending = base::ending_of(options.output);
    if (!options.output.empty())
        base::require_ending(options.output, {".txt", ".svg", ".obj", ".glb", ".gltf"}, "a grammar's word");
    const Grammar grammar = grammar_from(options.grammar);
    warn_of_contexts(grammar, options.grammar);
    DeriveOptions how;
    how.steps = options.steps;
    how.seed = base::Seed{options.seed};
    how.most_symbols = options.most_symbols;
    const Derivation derived = derive(grammar, how);
    if (!derived.stopped_by.empty())
        throw base::InputError(
            fmt::format("{}:{}: after {} steps the word has {} symbols, and one step more would pass {}: it is this "
                        "production that makes them: {}; ask for fewer --steps or allow more --most-symbols",
                        options.grammar, derived.stopped_by_line, derived.steps, derived.word.symbols.size(),
                        how.most_symbols, derived.stopped_by));
    if (options.output.empty() || ending == ".txt") {
        const std::string text = text_of(derived.word) + "\n";
        base::print_or_write_file(options.output.empty() ? "-" : options.output, text);
        return 0;
    }
    const TreeSkeleton skeleton = skeleton_of(grammar, derived.word, how.seed.child("turtle"));
    if (skeleton.limbs.empty())
        throw base::InputError(fmt::format("{}: its word draws nothing: there is no F in it", options.grammar));
    if (ending == ".svg") {
        base::write_file(options.output, svg_of(skeleton, grammar.name.empty() ? options.grammar : grammar.name));
        return 0;
    }
    const mesh::Model model = model_of(skeleton, options.limbs);
    base::write_file(options.output, mesh::model_file(model, ending));
    return 0;
}

}  // namespace

void add_lsystem(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand("lsystem", "Derive a grammar and print, draw or mesh its word");
    command.add_option("grammar", options->grammar, "A grammar file, or the name of one that comes along")
        .tells_default("none: needed unless --list is");
    command
        .add_option("-o,--output", options->output,
                    "NAME.txt, .svg, .obj, .glb or .gltf; the word on standard output otherwise")
        .tells_default("standard output");
    command.add_option("--steps", options->steps, "Derivation steps instead of the grammar's own")
        .between(0, 10'000)
        .tells_default("the grammar's");
    command.add_option("--seed", options->seed, "Names the chance of productions that are drawn").shows_default();
    command.add_option("--limbs", options->limbs, "Of a mesh: swept, smooth or cylinders")
        .among({"swept", "smooth", "cylinders"})
        .shows_default();
    command.add_option("--most-symbols", options->most_symbols, "Where a word that explodes is stopped")
        .between(std::size_t{1}, std::size_t{1} << 26U)
        .shows_default();
    command.add_option("--chance", options->chance, "Of a map: how far off its middle a wall divides")
        .between(0.0F, 0.8F)
        .shows_default();
    command.add_option("--pull", options->pull, "Of a map: rounds in which walls draw themselves short")
        .between(0, 64)
        .shows_default();
    command.add_flag("--list", options->is_listing, "Name the grammars that come along");
    command.does([options] { return derive_and_draw(*options); });
}

}  // namespace quadrat::commands
