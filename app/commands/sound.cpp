// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "base/error.hpp"
#include "base/file.hpp"
#include "commands/commands.hpp"
#include "pictures/picture.hpp"
#include "scene/parameters.hpp"
#include "sound/levels.hpp"
#include "sound/soundscape.hpp"
#include "sound/wav.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string scene;
    std::string output;
    double seconds = 30;
};

struct Measured {
    float peak = 0;
    float mean = 0;  // root of the mean square
};

Measured measured(sound::Block block) {
    Measured m;
    double sum = 0;
    for (const sound::Frame& frame : block) {
        m.peak = std::max({m.peak, std::abs(frame.left), std::abs(frame.right)});
        sum += static_cast<double>(frame.left * frame.left + frame.right * frame.right) / 2;
    }
    m.mean = static_cast<float>(std::sqrt(sum / static_cast<double>(block.size())));
    return m;
}

std::string in_words(const sound::Surroundings& heard) {
    std::string words;
    for (std::size_t i = 0; i < sound::kVoices; ++i) {
        const auto voice = static_cast<sound::Voice>(i);
        if (heard[voice] < 0.005F) continue;
        words += fmt::format("{}{} {:.2f}", words.empty() ? "" : ", ", sound::name_of(voice), heard[voice]);
    }
    return words.empty() ? "nothing" : words;
}

int write_sound(const Options& options) {
    base::require_ending(options.output, {".wav"}, "a soundscape");
    const pictures::Picture picture = pictures::read_scene(options.scene);
    if (picture.scenes.size() != 1)
        throw base::InputError(options.scene + ": it shows four scenes; a soundscape is of one");
    const genome::Recipe& recipe = picture.scenes.front();
    const sound::Surroundings heard = sound::surroundings_of(scene::realise(recipe.values));
    const sound::Soundscape soundscape(recipe.flight.child("sound"));
    std::vector<sound::Frame> frames(static_cast<std::size_t>(sound::frames_of(options.seconds)));
    soundscape.add(frames, 0, heard, heard);
    const Measured level = measured(frames);
    base::write_file(options.output, sound::wav_of(frames));
    std::printf("%s\n%.1f s, peak %.1f dBFS, mean %.1f dBFS\n", in_words(heard).c_str(), options.seconds,
                static_cast<double>(sound::decibels(level.peak)), static_cast<double>(sound::decibels(level.mean)));
    return 0;
}

}  // namespace

void add_sound(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command = program.add_subcommand("sound", "What is heard of a scene, as the exhibit plays it");
    command.add_option("scene", options->scene, "seed:N, a scene file, a scene code, or a picture that quadrat wrote")
        .required();
    command.add_option("-o,--output", options->output, "Where to write it: NAME.wav").required();
    command.add_option("--seconds", options->seconds, "How long, 0.1 to 600").between(0.1, 600.0).shows_default();
    command.does([options] { return write_sound(*options); });
}

}  // namespace quadrat::commands
