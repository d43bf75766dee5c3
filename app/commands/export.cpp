// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/file.hpp"
#include "commands/commands.hpp"
#include "mesh/model.hpp"
#include "nursery/growing.hpp"
#include "pictures/clamped_scene.hpp"
#include "pictures/image_file.hpp"
#include "pictures/picture.hpp"
#include "pictures/scene_export.hpp"
#include "pictures/tree_export.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string scene;
    std::string output;
    std::string what = "scene";
    std::string limbs = "drawn";
};

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
    if (options.what == "land") model.parts.push_back(pictures::land_part(*scene->land));
    if (options.what == "scene")
        model = pictures::scene_model(*scene,
                                      ending == ".obj" ? pictures::Instances::WrittenOut : pictures::Instances::Shared);
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
