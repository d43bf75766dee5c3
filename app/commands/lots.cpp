// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <glm/common.hpp>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text_file.hpp"
#include "commands/commands.hpp"
#include "commands/plan_json.hpp"
#include "genome/json_text.hpp"
#include "mesh/lots.hpp"

namespace quadrat::commands {
namespace {

using Loop = std::vector<glm::dvec2>;

struct Options {
    std::string region;
    std::string output = "-";
    std::uint64_t seed = 1;
    mesh::TownRules rules;
};

std::string points_of(const Loop& loop) {
    std::string text = "[";
    for (const glm::dvec2& p : loop)
        text += fmt::format("{}[{}, {}]", text.size() > 1 ? ", " : "", genome::shortest(p.x), genome::shortest(p.y));
    return text + "]";
}

std::string town_json(const mesh::TownPlan& town) {
    std::string text = "{\"blocks\": [";
    for (std::size_t i = 0; i < town.blocks.size(); ++i)
        text += fmt::format("{}{{\"outer\": {}}}", i == 0 ? "" : ",\n  ", points_of(town.blocks[i].front()));
    text += "],\n \"lots\": [";
    for (std::size_t i = 0; i < town.lots.size(); ++i) {
        const mesh::Lot& lot = town.lots[i];
        std::string streets;
        for (std::size_t e = 0; e < lot.is_street.size(); ++e)
            if (lot.is_street[e]) streets += fmt::format("{}{}", streets.empty() ? "" : ", ", e);
        text += fmt::format("{}{{\"block\": {}, \"outer\": {}, \"street_edges\": [{}]}}", i == 0 ? "" : ",\n  ",
                            lot.block, points_of(lot.outline_m), streets);
    }
    return text + "]}\n";
}

std::string town_svg(const mesh::TownPlan& town, const Loop& region) {
    glm::dvec2 low(1.0e300);
    glm::dvec2 high(-1.0e300);
    for (const glm::dvec2& p : region) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const double scale = 1000 / std::max({high.x - low.x, high.y - low.y, 1.0e-9});
    const auto path = [&](const Loop& loop) {
        std::string d;
        for (const glm::dvec2& p : loop)
            d += fmt::format("{}{:.2f} {:.2f}", d.empty() ? "M" : "L", 20 + scale * (p.x - low.x),
                             20 + scale * (high.y - p.y));
        return d + "Z";
    };
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#f6f3ea\"/>\n<path d=\"{}\" fill=\"#cbc4b4\"/>\n<g "
        "stroke=\"#4c4a44\">\n",
        40 + scale * (high.x - low.x), 40 + scale * (high.y - low.y), path(region));
    constexpr const char* kFills[] = {"#b9c79a", "#d9c99a", "#c7b08a", "#a9bd9d", "#d6bfa6"};
    for (const mesh::Lot& lot : town.lots)
        svg += fmt::format("<path d=\"{}\" fill=\"{}\" stroke-width=\"1.2\" stroke-linejoin=\"round\"/>\n",
                           path(lot.outline_m), kFills[static_cast<std::size_t>(lot.block) % std::size(kFills)]);
    return svg + "</g>\n</svg>\n";
}

int plan(const Options& options) {
    const bool is_printed = options.output == "-";
    if (!is_printed) base::require_ending(options.output, {".json", ".svg"}, "a plan of lots");
    const mesh::Plan region = region_from(base::read_text(options.region, base::kJsonLimits), options.region);
    if (!region.holes.empty())
        throw base::InputError(fmt::format("{}: a region for lots has no holes", options.region));
    mesh::TownPlan town;
    try {
        mesh::RoofOptions check;
        check.height_m = 1.0e-3;
        mesh::straight_skeleton(region, check);  // says what is wrong with its points
        town = mesh::plan_town(region.outer, options.rules, base::Seed{options.seed});
    } catch (const mesh::PlanError& error) {
        throw base::InputError(fmt::format("{}: {}", options.region, error.what()));
    }
    const std::string bytes =
        !is_printed && base::ending_of(options.output) == ".svg" ? town_svg(town, region.outer) : town_json(town);
    base::print_or_write_file(options.output, bytes);
    return 0;
}

}  // namespace

void add_lots(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand("lots", "Divide a region into blocks, streets and lots");
    command.add_option("region", options->region, "JSON, metres: {\"outer\": [[x, y], …]}").required();
    command.add_option("-o,--output", options->output, "NAME.json or .svg; -: JSON on standard output").shows_default();
    command.add_option("--seed", options->seed, "Of chance").shows_default();
    mesh::TownRules& rules = options->rules;
    command.add_option("--blocks", rules.sites, "Cells of the Voronoi diagram").between(1, 2000).shows_default();
    command.add_option("--uneven", rules.uneven, "How far some cells are ahead of others, 0 to 1: arcs for streets")
        .between(0.0, 1.0)
        .shows_default();
    command.add_option("--merged", rules.merged, "Share of cells that are joined with a neighbour")
        .between(0.0, 1.0)
        .shows_default();
    command.add_option("--street", rules.street_m, "Width of streets, metres").between(0.0, 100.0).shows_default();
    command.add_option("--largest", rules.lots.largest_m2, "Lots larger than this are split, square metres")
        .between(1.0, 1.0e9)
        .shows_default();
    command.add_option("--smallest", rules.lots.smallest_m2, "No split leaves less than this, square metres")
        .between(0.0, 1.0e9)
        .shows_default();
    command.add_option("--frontage", rules.lots.least_frontage_m, "Every lot has so much along a street, metres")
        .between(0.0, 1000.0)
        .shows_default();
    command.does([options] { return plan(*options); });
}

}  // namespace quadrat::commands
