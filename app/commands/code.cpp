// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "base/error.hpp"
#include "base/file.hpp"
#include "commands/commands.hpp"
#include "genome/scene_code.hpp"
#include "pictures/picture.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string scene;
    std::string code;
    std::string output;
};

int encode(const Options& options) {
    const pictures::Picture picture = pictures::read_scene(options.scene);
    if (picture.scenes.size() != 1) throw base::InputError(options.scene + ": it shows four scenes; a code is of one");
    std::printf("%s\n", genome::code_of(picture.scenes.front()).c_str());
    return 0;
}

int decode(const Options& options) {
    if (!options.output.empty()) base::require_ending(options.output, {".json"}, "a scene");
    const std::string json = genome::to_json(genome::recipe_of_code(options.code, "the code")) + "\n";
    if (options.output.empty())
        std::fputs(json.c_str(), stdout);
    else
        base::write_file(options.output, json);
    return 0;
}

}  // namespace

void add_code(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand("code", "A scene as one word, as the finale's QR code holds it");
    command.requires_subcommand();
    const Command to = command.add_subcommand("encode", "Print the code of a scene");
    to.add_option("scene", options->scene, "seed:N, a scene file, or a picture that quadrat wrote").required();
    to.does([options] { return encode(*options); });
    const Command from = command.add_subcommand("decode", "The scene of a code, which other commands draw and export");
    from.add_option("code", options->code, "Q1-…, alone or at the end of an address").required();
    from.add_option("-o,--output", options->output, "Where to write it: NAME.json").tells_default("the terminal");
    from.does([options] { return decode(*options); });
}

}  // namespace quadrat::commands
