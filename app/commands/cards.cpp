// SPDX-License-Identifier: Apache-2.0
// A page of what visitors bred lately, for whoever scanned a finale's code: whole without a script, so that any web
// server, or none, can serve it. A landscape's code is its figure's name: PAGE#CODE leads there.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/markup.hpp"
#include "breeding/words/nearest_words.hpp"
#include "commands/commands.hpp"
#include "genome/scene_code.hpp"
#include "genome/speech.hpp"
#include "site/state_folder.hpp"
#include "staff/landscapes.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPicture = 32U << 20U;

constexpr const char* kHead = R"(<!doctype html>
<html lang="{0}" dir="{1}">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{2}</title>
<style>
:root {{ color-scheme: light dark; font-family: Lato, "Noto Sans", system-ui, sans-serif; }}
body {{ margin: 0 auto; max-width: 70rem; padding: 1rem; }}
main {{ display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 20rem), 1fr)); gap: 1.5rem; }}
figure {{ margin: 0; scroll-margin-top: 1rem; }}
figure:target {{ grid-column: 1 / -1; order: -1; outline: .25rem solid currentColor; outline-offset: .5rem; }}
img {{ display: block; width: 100%; height: auto; border-radius: .3rem; }}
a {{ display: inline-block; padding-block: .6rem; color: inherit; }}
</style>
<h1>{2}</h1>
<main>
)";

struct Options {
    std::string output;
    std::string state;
    std::string language = "en";
    std::string place = "Quadrat";
};

// What a page before this one left, and nothing else.
void remove_others(const fs::path& folder, const std::set<std::string>& names) {
    constexpr std::size_t kId = 16;
    std::error_code error;
    std::vector<fs::path> gone;
    for (const auto& file : fs::directory_iterator(folder, error)) {
        const std::string name = file.path().filename().string();
        const std::string ending = name.substr(std::min(kId, name.size()));
        const bool is_ours =
            (ending == ".png" || ending == staff::kPostcard) && name.find_first_not_of("0123456789abcdef") == kId;
        if (is_ours && !names.contains(name)) gone.push_back(file.path());
    }
    for (const fs::path& file : gone) fs::remove(file, error);
}

int write_page(const Options& options) {
    const fs::path bred = site::watched_folder(options.state) / staff::kBredLately;
    const fs::path folder = options.output;
    std::error_code error;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder, error)) throw base::InputError(options.output + ": no folder can be made there");
    const genome::Language& language = genome::language(options.language);
    std::string page = fmt::format(kHead, options.language, language.reads_right_to_left() ? "rtl" : "ltr",
                                   base::escaped(options.place));
    std::set<std::string> names;
    std::size_t count = 0;
    for (const staff::KeptLandscape& one : staff::landscapes_in(bred)) {
        try {
            for (const std::string& name : {one.id + ".png", one.id + staff::kPostcard}) {
                const std::string bytes = base::read_file(bred / name, kMostPicture);
                base::write_file(folder / name, bytes);
                names.insert(name);
            }
        } catch (const base::InputError&) {
            if (!fs::exists(bred / (one.id + staff::kPostcard), error)) continue;  // it has gone, or is not drawn yet
            throw;
        }
        const genome::Recipe recipe = genome::recipe_of_code(one.code, one.id);
        genome::Description words;
        for (const genome::Aspect aspect : genome::kAspects)
            words = breeding::words_of_scene(recipe.values, aspect, breeding::default_word_map(), words);
        page += fmt::format(
            "<figure id=\"{0}\">\n<img src=\"{1}.png\" width=\"480\" height=\"270\" alt=\"\">\n"
            "<figcaption>{2}<br>\n<a href=\"{1}{3}\">{4}</a></figcaption>\n</figure>\n",
            base::escaped(one.code), one.id, base::escaped(language.describe(words)), staff::kPostcard,
            base::escaped(genome::prompt(options.language, "print")));
        ++count;
    }
    base::write_file(folder / "index.html", page + "</main>\n</html>\n");
    remove_others(folder, names);
    std::printf("%s: %zu landscapes\n", fs::absolute(folder / "index.html").lexically_normal().c_str(), count);
    return 0;
}

}  // namespace

void add_cards(const Command& program) {
    auto options = std::make_shared<Options>();
    const std::vector<std::string_view> codes = genome::language_codes();
    const Command command =
        program.add_subcommand("cards",
                               "A page of what visitors bred lately, with a postcard of each, for any web "
                               "server: what the finale's code leads to, "
                               "with take_home.url = \"https://THE PAGE/#\"");
    command.add_option("-o,--output", options->output, "The folder for index.html and its pictures").required();
    command.add_option("--state", options->state, "The exhibit's state folder, when it is not the service")
        .tells_default("the service's");
    command.add_option("--language", options->language, "That words are in, as de")
        .among({codes.begin(), codes.end()})
        .shows_default();
    command.add_option("--place", options->place, "The page's title, as \"Museum of Landscapes\"").shows_default();
    command.does([options] { return write_page(*options); });
}

}  // namespace quadrat::commands
