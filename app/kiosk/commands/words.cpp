// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "base/error.hpp"
#include "breeding/words/word_map.hpp"
#include "genome/speech.hpp"
#include "kiosk/commands/commands.hpp"
#include "kiosk/easel.hpp"

namespace quadrat::kiosk::commands {
namespace {

struct Options {
    std::string language = "en";
    std::string output;
    std::string size = "320x180";
    int steps = 5;
    std::uint64_t seed = 1;
};

int show(const Options& options) {
    const breeding::WordMap& map = breeding::default_word_map();
    const genome::Language& language = genome::language(options.language);
    for (const genome::Aspect aspect : genome::kAspects) {
        int scenes = 0;
        for (const breeding::DescribedScene& scene : map.scenes()) scenes += scene.aspect == aspect;
        fmt::print("{}: {} described scenes; a scene told from the others is off by {:.0f} % of a range\n",
                   name_of(aspect), scenes, 100 * map.leave_one_out(aspect));
        for (const genome::Word& word : genome::vocabulary(aspect))
            fmt::print("  {:<14} {} ← → {}    {}\n", word.name, language.end(word.id, false),
                       language.end(word.id, true), word.meaning);
    }
    return 0;
}

// A row a word, from one end to the other, all other words left in the middle, on one land under one sky.
int draw_sheet(const Options& options) {
    const display::Size size = display::size_from(options.size, "--size");
    const std::filesystem::path folder = std::filesystem::path(options.output).parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder))
        throw base::InputError(fmt::format("--output: there is no folder {}", folder.string()));
    Picture picture;
    picture.width = size.width;
    picture.height = size.height;
    Easel easel(picture.width, picture.height);
    const genome::Language& language = genome::language(options.language);
    const genome::Recipe seeds = genome::random_recipe(base::Seed{options.seed});
    std::vector<SheetEntry> entries;
    for (const genome::Word& word : genome::vocabulary()) {
        for (int step = 0; step < options.steps; ++step) {
            const float value = -1 + 2 * static_cast<float>(step) / static_cast<float>(options.steps - 1);
            genome::Description words;
            words.set(word.id, value);
            genome::Recipe recipe = seeds;
            recipe.values = breeding::default_word_map()(words);
            picture.scenes = {recipe};
            entries.push_back(
                {easel.draw(picture), fmt::format("{} {:+.1f}", language.end(word.id, value > 0), value)});
        }
        std::cerr << fmt::format("{} of {}\n", entries.size() / static_cast<std::size_t>(options.steps),
                                 genome::kWordCount);
    }
    write_image(options.output, contact_sheet(entries, options.steps, picture.width));
    std::cout << options.output << '\n';
    return 0;
}

}  // namespace

void add_words(CLI::App& app, Action& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("words", "The words that wishes are held in, and what they look like");
    command->require_subcommand(1);
    command->add_option("--language", options->language, "Of their ends: ar, de, en, es, fr, xh")
        ->capture_default_str();
    CLI::App* shown = command->add_subcommand("show", "Every word with its two ends, and how well the map knows them");
    shown->callback([options, &chosen] { chosen = [options] { return show(*options); }; });
    CLI::App* sheet = command->add_subcommand("sheet", "A picture with a row a word, from one end to the other");
    sheet->add_option("-o,--output", options->output, "FILE.png")->required();
    sheet->add_option("--size", options->size, "Of each picture, in pixels")->capture_default_str();
    sheet->add_option("--steps", options->steps, "Pictures a row")->check(CLI::Range(2, 21))->capture_default_str();
    sheet->add_option("--seed", options->seed, "Names the places")->capture_default_str();
    sheet->callback([options, &chosen] { chosen = [options] { return draw_sheet(*options); }; });
}

}  // namespace quadrat::kiosk::commands
