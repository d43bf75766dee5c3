// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>

#include "base/error.hpp"
#include "commands/commands.hpp"
#include "pictures/picture.hpp"
#include "stage/easel.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string scene;
    std::string output;
    std::string size;
    std::string camera;
    std::optional<float> seconds;
    std::optional<float> detail;
    std::optional<int> samples;
    bool has_wires = false;
    std::string ground;
    std::optional<float> growth;
    tempo::Budget budget;
};

scene::Camera camera_from(const std::string& text) {
    scene::Camera c;
    char rest = 0;
    const int read = std::sscanf(text.c_str(), "%f,%f,%f:%f,%f,%f:%f%c", &c.eye_m.x, &c.eye_m.y, &c.eye_m.z,
                                 &c.target_m.x, &c.target_m.y, &c.target_m.z, &c.vertical_fov_deg, &rest);
    if (read != 6 && read != 7)
        throw base::InputError(fmt::format(
            "--camera {}: write EYE:TARGET or EYE:TARGET:FOV, each point as X,Y,Z in metres: 0,12,80:0,8,0:42", text));
    if (c.eye_m == c.target_m || c.vertical_fov_deg < 5 || c.vertical_fov_deg > 120)
        throw base::InputError(
            fmt::format("--camera {}: the eye must not be the target, and the view 5 to 120 degrees wide", text));
    return c;
}

int draw(const Options& options) {
    pictures::check_picture_name(options.output);
    pictures::Picture picture = pictures::read_scene(options.scene);
    if (!options.size.empty()) {
        const display::Size size = display::size_from(options.size, "--size");
        picture.width = size.width;
        picture.height = size.height;
    }
    if (!options.camera.empty()) picture.camera = camera_from(options.camera);
    if (options.seconds) picture.seconds = *options.seconds;
    if (options.detail) picture.alpha = *options.detail;
    if (options.samples) picture.samples = *options.samples;
    if (options.has_wires) picture.has_wires = true;
    if (!options.ground.empty()) picture.ground = render::ground_named(options.ground);
    if (options.growth) picture.growth = *options.growth;
    stage::Easel easel(picture.width, picture.height, picture.ground);
    const mesh::Image pixels = easel.draw(picture, options.budget);
    pictures::write_picture(options.output, pixels, to_json(picture));
    return 0;
}

}  // namespace

void add_render(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command =
        program.add_subcommand("render", "Draw one scene to a PNG or EXR that carries the scene inside");
    command.add_option("scene", options->scene, "seed:N, a scene file, a picture that quadrat wrote, or a scene code")
        .required();
    command.add_option("-o,--output", options->output, "Where to write it: NAME.png or NAME.exr").required();
    command.add_option("--size", options->size, "Width and height in pixels, as 1280x720")
        .tells_default("the scene's, else 1280x720");
    command.add_option("--time", options->seconds, "Seconds into the flight")
        .between(0.0F, 1e6F)
        .tells_default("the scene's, else 0");
    command.add_option("--camera", options->camera, "EX,EY,EZ:TX,TY,TZ[:FOV] instead of the flight's, metres, degrees")
        .tells_default("the flight's");
    command.add_option("--detail", options->detail, "alpha: 1 is standard, 0.25 coarse, 4 fine")
        .between(0.01F, 100.0F)
        .tells_default("the scene's, else 1");
    command.add_option("--triangles", options->budget.triangles, "In so much detail that no more are drawn")
        .tells_default("no limit");
    command.add_option("--pixels", options->budget.pixels, "No more of the landscape; spread over the picture")
        .tells_default("no limit");
    command.add_option("--samples", options->samples, "A pixel: 1, or 4 for smooth edges")
        .among({1, 4})
        .tells_default("the scene's, else 1");
    command.add_flag("--wires", options->has_wires,
                     "With the edges of all triangles, warm where fine, cold where coarse");
    command.add_option("--ground", options->ground, "What draws the land: blocks (standard) or roam")
        .among(render::ground_names())
        .tells_default("the scene's, else blocks");
    command.add_option("--growth", options->growth, "0 seedlings to 1 grown")
        .between(0.0F, 1.0F)
        .tells_default("the scene's, else 1");
    command.does([options] { return draw(*options); });
}

}  // namespace quadrat::commands
