// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "base/file.hpp"
#include "commands/commands.hpp"
#include "mesh/model.hpp"
#include "nursery/growing.hpp"
#include "pictures/clamped_scene.hpp"
#include "pictures/image_file.hpp"
#include "pictures/picture.hpp"
#include "pictures/tree_export.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string scene;
    std::string output;
    std::string what = "scene";
    std::string limbs = "drawn";
};

mesh::Model::Part wood_of(const scene::Species& species, const std::string& name, std::size_t level) {
    return {name + "_wood", species.wood.at(std::min(level, species.wood.size() - 1)).mesh, species.bark_colour};
}

mesh::Model::Part land_part(const scene::Land& land) {
    mesh::Model::Part part{"land", {}, land.far_colour};
    const int n = land.height_m.columns;
    const float middle = static_cast<float>(n - 1) / 2;
    for (int row = 0; row < land.height_m.rows; ++row) {
        for (int column = 0; column < n; ++column) {
            const glm::vec2 at{(static_cast<float>(column) - middle) * land.cell_m,
                               (static_cast<float>(row) - middle) * land.cell_m};
            part.mesh.positions_m.emplace_back(at.x, land.height_m.at(column, row), at.y);
            part.mesh.normals.push_back(scene::ground_normal(land, at));
            if (row + 1 == land.height_m.rows || column + 1 == n) continue;
            const auto a = static_cast<std::uint32_t>(land.height_m.index(column, row));
            const auto below = a + static_cast<std::uint32_t>(n);
            for (const std::uint32_t index : {a, below, a + 1, a + 1, below, below + 1})
                part.mesh.indices.push_back(index);
        }
    }
    return part;
}

// Instances are free in glTF; in OBJ every plant is written out, so there the coarsest wood must do.
mesh::Model scene_model(const scene::Scene& scene, bool writes_instances_out) {
    mesh::Model model;
    model.parts.push_back(land_part(*scene.land));
    model.placed.push_back({});
    for (std::size_t i = 0; i < scene.flora->species.size(); ++i) {
        const scene::Species& species = scene.flora->species[i];
        const std::string name = fmt::format("species{}", i);
        model.parts.push_back(wood_of(species, name, writes_instances_out ? 99 : 0));
        model.parts.push_back(pictures::leaves_part(species, name));
    }
    for (const scene::Plant& plant : scene.plants)
        for (std::size_t part = 0; part < 2; ++part)
            model.placed.push_back({1 + 2 * plant.species + part, plant.root_m, plant.yaw_rad, plant.scale});
    return model;
}

int write(const Options& options) {
    const std::string ending = base::ending_of(options.output);
    const bool is_model = std::ranges::find(mesh::kModelEndings, ending) != mesh::kModelEndings.end();
    const bool is_heights = options.what == "land" && !is_model;
    if (options.what == "land")
        base::require_ending(options.output, {".obj", ".glb", ".gltf", ".exr", ".tif", ".tiff"},
                             "land, or its heights,");
    else
        base::require_ending(options.output, {".obj", ".glb", ".gltf"}, "a " + options.what);
    const pictures::Picture picture = pictures::read_scene_clamped(options.scene);
    const auto in_format = [&](const mesh::Model& model) { return mesh::model_file(model, ending); };
    if (options.what == "tree") {  // which needs neither land nor sky
        base::write_file(options.output,
                         in_format(pictures::tree_model(picture.scenes.front(), pictures::limbs_from(options.limbs))));
        return 0;
    }
    const auto scene = nursery::grow(picture.scenes.front());
    if (is_heights) {
        base::write_file(options.output, pictures::encoded_field(options.output, scene->land->height_m));
        return 0;
    }
    mesh::Model model;
    if (options.what == "land") model.parts.push_back(land_part(*scene->land));
    if (options.what == "scene") model = scene_model(*scene, ending == ".obj");
    base::write_file(options.output, in_format(model));
    return 0;
}

}  // namespace

void add_export(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand("export", "Write a scene's geometry for other tools");
    command.add_option("scene", options->scene, "seed:N, a scene file, or a picture that quadrat wrote").required();
    command
        .add_option("-o,--output", options->output, "NAME.obj, .glb or .gltf; heights of the land as NAME.exr or .tif")
        .required();
    command.add_option("--what", options->what, "tree, land or scene").among({"tree", "land", "scene"}).shows_default();
    command.add_option("--limbs", options->limbs, "Of a tree: drawn, smooth (one surface), swept or cylinders")
        .among({"drawn", "smooth", "swept", "cylinders"})
        .shows_default();
    command.does([options] { return write(*options); });
}

}  // namespace quadrat::commands
