// SPDX-License-Identifier: Apache-2.0
#include "pictures/postcard.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>

#include "base/error.hpp"
#include "base/file.hpp"
#include "breeding/words/nearest_words.hpp"
#include "breeding/words/word_map.hpp"
#include "commands/commands.hpp"
#include "genome/scene_code.hpp"
#include "genome/speech.hpp"
#include "pictures/picture.hpp"
#include "site/wall_clock.hpp"
#include "stage/easel.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string scene;
    std::string output;
    std::string title;
    std::string language = "en";
    std::string place;
    std::string date;
    std::string address;
    std::optional<float> seconds;
    bool has_no_code = false;
};

std::string title_of(const genome::Recipe& recipe, const genome::Language& language) {
    genome::Description words;
    for (const genome::Aspect aspect : genome::kAspects)
        words = breeding::words_of_scene(recipe.values, aspect, breeding::default_word_map(), words);
    return language.describe(words);
}

std::string today() { return site::date_text(site::read_wall_clock(site::LastTimeSeen({})).date); }

int draw(const Options& options) {
    base::require_ending(options.output, {".png"}, "a postcard");
    const genome::Language& language = genome::language(options.language);
    pictures::Picture picture = pictures::read_scene(options.scene);
    if (picture.scenes.size() != 1)
        throw base::InputError(options.scene + ": it shows four scenes; a postcard is of one");
    picture.width = pictures::kOnPostcard_px.x;
    picture.height = pictures::kOnPostcard_px.y;
    picture.samples = 4;
    picture.alpha = 2;
    if (options.seconds) picture.seconds = *options.seconds;
    stage::Easel easel(picture.width, picture.height, picture.ground);
    pictures::Postcard card;
    card.landscape = easel.draw(picture);
    card.title = options.title.empty() ? title_of(picture.scenes.front(), language) : options.title;
    const std::string date = options.date.empty() ? today() : options.date;
    // Apart from what is written the other way.
    const std::string when = fmt::format("\u2066{}\u2069", date);
    card.below = options.place.empty() ? when : fmt::format("{} · {}", options.place, when);
    if (!options.has_no_code) card.code = options.address + genome::code_of(picture.scenes.front());
    card.reads_right_to_left = language.reads_right_to_left();
    pictures::write_picture(options.output, pictures::draw_postcard(card), to_json(picture));
    std::printf("%s\n", std::filesystem::absolute(options.output).lexically_normal().c_str());
    return 0;
}

}  // namespace

void add_postcard(const Command& program) {
    auto options = std::make_shared<Options>();
    const std::vector<std::string_view> codes = genome::language_codes();
    const Command command = program.add_subcommand(
        "postcard", "A landscape on a card of 148 x 105 mm: its picture, its words, where and when, and its code");
    command.add_option("scene", options->scene, "seed:N, a scene file, a picture that quadrat wrote, or a scene code")
        .required();
    command.add_option("-o,--output", options->output, "Where to write it: NAME.png, which carries the scene inside")
        .required();
    command.add_option("--title", options->title, "Instead of its words").tells_default("its words");
    command.add_option("--language", options->language, "That its words are in, as de")
        .among({codes.begin(), codes.end()})
        .shows_default();
    command.add_option("--place", options->place, "Where it was bred, as \"Museum of Landscapes\"")
        .tells_default("none");
    command.add_option("--date", options->date, "When").tells_default("today, as 2026-10-12");
    command.add_option("--address", options->address, "Before its code, as take_home.url among the settings")
        .tells_default("none");
    command.add_option("--time", options->seconds, "Seconds into the flight")
        .between(0.0F, 1e6F)
        .tells_default("the scene's, else 0");
    command.add_flag("--no-code", options->has_no_code, "Without its code");
    command.does([options] { return draw(*options); });
}

}  // namespace quadrat::commands
