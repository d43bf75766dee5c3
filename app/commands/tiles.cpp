// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <glm/geometric.hpp>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text_file.hpp"
#include "commands/commands.hpp"
#include "mesh/model.hpp"
#include "synthesis/land/tile_examples.hpp"

namespace quadrat::commands {
namespace {

using namespace synthesis;

struct Options {
    std::string example;
    std::string output;
    std::string size = "14x12x4";
    std::uint64_t seed = 1;
    float decay = 0.3F;
    bool is_listing = false;
};

struct Example {
    noise::Tiles tiles;
    std::vector<noise::Weight> weights;
};

Example example_from(const Options& options) {
    const std::string& name = options.example;
    if (std::filesystem::exists(name)) return {noise::tiles_from(base::read_text(name), name), {}};
    const auto examples = land::tile_examples();
    const auto found = std::ranges::find(examples, name, &land::TileExample::name);
    if (found == examples.end())
        throw base::InputError(
            fmt::format("{}: there is no such file; quadrat tiles --list names the examples that come along", name));
    return {noise::tiles_from(found->text, name), land::weights_of(*found, options.decay)};
}

glm::ivec3 size_from(const std::string& text) {
    glm::ivec3 size{0};
    char rest = 0;
    const int read = std::sscanf(text.c_str(), "%dx%dx%d%c", &size.x, &size.y, &size.z, &rest);
    const auto is_right = [](int side) { return side >= 1 && side <= noise::kMostTilesASide; };
    if (read != 3 || !is_right(size.x) || !is_right(size.y) || !is_right(size.z))
        throw base::InputError(fmt::format("--size {}: write EASTxSOUTHxUP in tiles, each 1 to {}, as 14x12x4", text,
                                           noise::kMostTilesASide));
    return size;
}

mesh::Model model_of(const noise::Tiles& tiles, base::Seed seed) {
    mesh::Model model;
    model.parts.push_back({"tiles", {}, {0.45F, 0.42F, 0.36F}});
    mesh::Mesh& mesh = model.parts.front().mesh;
    for (const land::TileFacet& facet : land::facets_of(tiles, {}, seed)) {
        const glm::vec3 normal =
            glm::normalize(glm::cross(facet.corners[1] - facet.corners[0], facet.corners[2] - facet.corners[0]));
        for (const glm::vec3& corner : facet.corners) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions_m.size()));
            mesh.positions_m.push_back(corner);
            mesh.normals.push_back(normal);
        }
    }
    return model;
}

int make(const Options& options) {
    if (options.is_listing) {
        for (const land::TileExample& one : land::tile_examples()) fmt::print("{:<10} {}\n", one.name, one.meaning);
        return 0;
    }
    if (options.example.empty())
        throw base::InputError("tiles: name an example: a file, or one of quadrat tiles --list");
    const std::string ending = base::ending_of(options.output);
    if (!options.output.empty())
        base::require_ending(options.output, {".txt", ".obj", ".glb", ".gltf"}, "a box of tiles");
    const glm::ivec3 size = size_from(options.size);
    const base::Seed seed{options.seed};
    const Example example = example_from(options);
    noise::Parts parts;
    const noise::Tiles tiles = noise::synthesise(example.tiles, size, example.weights, seed, &parts);
    if (parts.made == 0)
        throw base::InputError(fmt::format("{}: no part of {} could be made of it; nothing of it fits beside air",
                                           options.example, options.size));
    if (options.output.empty() || ending == ".txt") {
        base::print_or_write_file(options.output.empty() ? "-" : options.output, noise::text_of(tiles));
        return 0;
    }
    const mesh::Model model = model_of(tiles, seed.child("shape"));
    if (model.parts.front().mesh.indices.empty())
        throw base::InputError(fmt::format("{}: there is nothing but air in it", options.example));
    base::write_file(options.output, mesh::model_file(model, ending));
    return 0;
}

}  // namespace

void add_tiles(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command =
        program.add_subcommand("tiles", "Fill a box with tiles as an example has them, and print or mesh it");
    command.add_option("example", options->example, "A file of tiles, or the name of an example that comes along")
        .tells_default("none: needed unless --list is");
    command
        .add_option("-o,--output", options->output,
                    "NAME.txt, .obj, .glb or .gltf; layers on standard output otherwise")
        .tells_default("standard output");
    command.add_option("--size", options->size, "EASTxSOUTHxUP, in tiles").shows_default();
    command.add_option("--seed", options->seed, "Of chance").shows_default();
    command.add_option("--decay", options->decay, "Of an example that comes along: how much has fallen")
        .between(0.0F, 1.0F)
        .shows_default();
    command.add_flag("--list", options->is_listing, "Name the examples that come along");
    command.does([options] { return make(*options); });
}

}  // namespace quadrat::commands
