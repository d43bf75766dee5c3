// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>

#include "archive/word_answers.hpp"
#include "backup/staged.hpp"
#include "backup/state_hold.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text_file.hpp"
#include "breeding/reach.hpp"
#include "breeding/words/comes_back.hpp"
#include "breeding/words/own_word.hpp"
#include "breeding/words/questions.hpp"
#include "commands/commands.hpp"
#include "commands/words_axes.hpp"
#include "genome/speech.hpp"
#include "learning/past_visits.hpp"
#include "learning/school.hpp"
#include "nursery/growing.hpp"
#include "pictures/tree_view.hpp"
#include "site/state_folder.hpp"
#include "stage/easel.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string language = "en";
    std::string state;
    std::string output;
    std::vector<std::string> files;
    bool is_anyway = false;
    bool is_sure = false;
    double value = 1;
    std::string size = "320x180";
    int steps = 5;
    std::string aspect = "trees";
    std::size_t first = 0;
    std::size_t count = 24;
    int visits = 40;
    int offers = 7;
    bool is_all = false;
    std::uint64_t seed = 1;
};

// With --state the site's own; otherwise the one that the program brings along.
breeding::WordMap map_for(const Options& options) {
    return options.state.empty() ? breeding::default_word_map()
                                 : learning::site_words(site::existing_state_folder(options.state)).map;
}

// What each scene taught: how far around it is heard, and how near its own words come to it again.
void show_scenes(const breeding::WordMap& map, genome::Aspect aspect) {
    const auto all = breeding::how_scenes_come_back(map);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const breeding::DescribedScene& scene = map.scenes()[i];
        if (scene.aspect != aspect) continue;
        const breeding::ComesBack& back = all[i];
        fmt::print("  {:<32} heard within {:.2f}; comes back within {:.1f} % of a range",
                   scene.name.empty() ? fmt::format("number {}", i + 1) : scene.name, back.radius, 100 * back.error);
        if (back.worst_error > 0.02)
            fmt::print(", {} off by {:.0f} %", parameter(back.worst).name, 100 * back.worst_error);
        fmt::print("\n");
    }
}

// What visitors end up with, where that moved what is believed before a pick.
void show_taste(const std::filesystem::path& folder, const breeding::WordMap& map) {
    const breeding::Taste taste = learning::site_taste(folder);
    for (const genome::Aspect aspect : genome::kAspects) {
        const std::vector<std::string>& names = map.atlas(aspect).names;
        for (const auto& [name, count] : taste.chosen[aspect])
            fmt::print("{}: {} visits ended with {}, which is held {:.1f} times as likely\n", name_of(aspect), count,
                       name, breeding::weight_of(taste, aspect, name, names.size()));
    }
}

int show(const Options& options) {
    const breeding::WordMap map = map_for(options);
    const genome::Language& language = genome::language(options.language);
    for (const genome::Aspect aspect : genome::kAspects) {
        int scenes = 0;
        for (const breeding::DescribedScene& scene : map.scenes()) scenes += scene.aspect == aspect;
        fmt::print("{}: {} described scenes; a scene told from the others is off by {:.0f} % of a range\n",
                   name_of(aspect), scenes, 100 * map.leave_one_out(aspect));
        if (options.is_all) show_scenes(map, aspect);
        for (const genome::Word& word : genome::vocabulary(aspect))
            fmt::print("  {:<14} {} ← → {}    {}\n", word.name, language.end(word.id, false),
                       language.end(word.id, true), word.meaning);
    }
    if (!options.state.empty()) show_taste(site::existing_state_folder(options.state), map);
    return 0;
}

// Visits in which anything is named best, over the map's own breeder: what no pick moves is no gene.
int tell_reach(const Options& options) {
    breeding::BreederOptions breeder;
    breeder.kind = breeding::BreederKind::Belief;
    breeder.genome = genome::Genome::Full;
    breeder.map = map_for(options);
    const breeding::Reach reach = breeding::reach_of(breeder, {options.visits, options.offers});
    std::cout << text_of(reach, options.is_all);
    return 0;
}

// Said of a tree, and seen beside it; the other words for trees are said of the stand.
bool is_of_one_tree(genome::WordId id) {
    return word(id).aspect == genome::Aspect::Trees && id != genome::WordId::sparse && id != genome::WordId::tall;
}

// A row a word, from one end to the other, all other words left free, on one land under one sky.
int draw_sheet(const Options& options) {
    const display::Size size = display::size_from(options.size, "--size");
    pictures::check_picture_name(options.output);
    pictures::Picture picture;
    picture.width = size.width;
    picture.height = size.height;
    const breeding::WordMap map = map_for(options);
    stage::Easel easel(picture.width, picture.height);
    const genome::Language& language = genome::language(options.language);
    const genome::Recipe seeds = genome::random_recipe(base::Seed{options.seed});
    std::vector<pictures::SheetEntry> entries;
    for (const genome::Word& word : genome::vocabulary()) {
        for (int step = 0; step < options.steps; ++step) {
            const float value = -1 + 2 * static_cast<float>(step) / static_cast<float>(options.steps - 1);
            genome::PartialDescription words{};
            words[static_cast<std::size_t>(word.id)] = value;
            genome::Recipe recipe = seeds;
            recipe.values = map(map.completed(words));
            picture.scenes = {recipe};
            const nursery::Scenes scenes{nursery::grow(recipe)};
            picture.camera.reset();
            if (is_of_one_tree(word.id)) picture.camera = pictures::camera_on_a_tree(*scenes.front());
            entries.push_back(
                {easel.draw(picture, scenes), fmt::format("{} {:+.1f}", language.end(word.id, value > 0), value)});
        }
        std::cerr << fmt::format("{} of {}\n", entries.size() / static_cast<std::size_t>(options.steps),
                                 genome::kWordCount);
    }
    pictures::write_image(options.output, pictures::contact_sheet(entries, options.steps, picture.width));
    std::cout << options.output << '\n';
    return 0;
}

void write_and_name(const std::string& output, std::string_view bytes) {
    base::write_file(output, bytes);
    std::cout << output << '\n';
}

// A site without a state file has no answers yet.
archive::WordAnswers answers_of(const std::filesystem::path& folder) {
    if (!std::filesystem::exists(folder / "quadrat.db")) return {};
    return archive::word_answers_in(folder);
}

// Landscapes spread evenly over the words of an aspect, for a curator to look at and to describe; then `train` learns.
int ask(const Options& options) {
    base::require_ending(options.output, {".json"}, "scenes to be described");
    const genome::Aspect aspect = *genome::aspect_named(options.aspect);
    const auto scenes = breeding::scenes_to_describe(map_for(options), aspect, options.first, options.count);
    const display::Size size = display::size_from(options.size, "--size");
    pictures::Picture picture;
    picture.width = size.width;
    picture.height = size.height;
    stage::Easel easel(picture.width, picture.height);
    genome::Recipe recipe = genome::random_recipe(base::Seed{options.seed});
    std::vector<pictures::SheetEntry> entries;
    for (const breeding::DescribedScene& scene : scenes) {
        recipe.values = scene.values;
        picture.scenes = {recipe};
        entries.push_back({easel.draw(picture), scene.name});
    }
    const std::string sheet = std::filesystem::path(options.output).replace_extension(".png").string();
    pictures::write_image(sheet, pictures::contact_sheet(entries, 4, picture.width));
    std::cout << sheet << '\n';
    write_and_name(options.output, to_json(scenes, aspect));
    return 0;
}

// What is in the files replaces what the curator taught before; what visitors said is read again.
int train(const Options& options) {
    const std::filesystem::path folder = site::existing_state_folder(options.state);
    std::error_code ignored;  // only the user's own is made; where that cannot be, the lock says so
    std::filesystem::create_directories(folder, ignored);
    const auto lock = backup::hold_state(folder, "quadrat words train");
    const learning::SiteWords before = learning::site_words(folder);
    breeding::Lessons wanted{before.lessons.curator, {}};
    if (!options.files.empty()) wanted.curator.clear();
    for (const std::string& file : options.files) {
        const breeding::Lessons read = breeding::word_lessons_from(base::read_text(file, base::kJsonLimits), file);
        wanted.curator.insert(wanted.curator.end(), read.curator.begin(), read.curator.end());
    }
    const archive::WordAnswers answers = answers_of(folder);
    wanted.visitors = breeding::lessons_from(answers.readable);
    if (answers.unreadable > 0)
        std::cerr << fmt::format("words: {} answers speak of what this program does not know, and are left out\n",
                                 answers.unreadable);
    const breeding::Training training = breeding::train(
        wanted, before.lessons, before.map, options.is_anyway ? breeding::Worse::Take : breeding::Worse::Refuse);
    for (const std::string& line : training.said) std::cerr << fmt::format("words: {}\n", line);
    if (training.lessons != before.lessons) learning::keep_site_words(folder, training.lessons);
    for (const genome::Aspect aspect : genome::kAspects)
        fmt::print("{}: a scene told from the others is off by {:.2f} % of a range; before, by {:.2f} %\n",
                   name_of(aspect), 100 * training.map.leave_one_out(aspect), 100 * before.map.leave_one_out(aspect));
    fmt::print("{}\n", training.lessons == before.lessons ? "the map stays" : "the map is another");
    if (std::filesystem::exists(folder / "quadrat.db"))
        learning::keep_site_taste(folder, learning::counted_taste(folder));
    return 0;
}

// What a word of one's own means in words; with --output, the scene it asks for.
int tell_own(const Options& options) {
    if (!options.output.empty()) base::require_ending(options.output, {".json"}, "a scene");
    const breeding::WordMap map = map_for(options);
    const std::string& file = options.files.front();
    const breeding::OwnWord own = breeding::own_word_from(base::read_text(file, base::kJsonLimits), file, map);
    fmt::print("{}, of the {}: told from the other scenes, one is off by {:.2f}; without words, by {:.2f}\n", own.name,
               name_of(own.aspect), own.leave_one_out, own.spread_of_said);
    const auto vocabulary = genome::vocabulary(own.aspect);
    for (std::size_t i = 0; i < vocabulary.size(); ++i)
        fmt::print("  {:<14} {:+.2f}\n", vocabulary[i].name, own.direction.weights[i]);
    const genome::Description words = map.completed({}, std::vector{own.at(options.value)});
    fmt::print("{:+.2f} is {}\n", options.value, genome::language(options.language).describe(words, own.aspect));
    if (own.leave_one_out >= own.spread_of_said)
        std::cerr << fmt::format("words: {}: the words of the {} do not tell what it is\n", own.name,
                                 name_of(own.aspect));
    if (options.output.empty()) return 0;
    genome::Recipe recipe = genome::random_recipe(base::Seed{options.seed});
    recipe.values = map(words);
    write_and_name(options.output, genome::to_json(recipe) + "\n");
    return 0;
}

int export_lessons(const Options& options) {
    base::require_ending(options.output, {".json"}, "what was taught");
    const std::filesystem::path folder = site::existing_state_folder(options.state);
    const archive::WordAnswers answers = archive::word_answers_in(folder);
    write_and_name(options.output, to_json(breeding::Lessons{learning::site_words(folder).lessons.curator,
                                                             breeding::lessons_from(answers.readable)}));
    return 0;
}

// Whoever sits there says so; a script says it beforehand.
void require_consent(const Options& options, std::size_t count) {
    if (options.is_sure) return;
    const std::string what = fmt::format("{} answers of visitors, and what was learnt of them, are deleted", count);
    if (::isatty(STDIN_FILENO) == 0) throw base::InputError(what + "; to go on, say so with --yes");
    fmt::print(stderr, "{}. Go on? Type yes: ", what);
    std::string answer;
    std::getline(std::cin, answer);
    if (answer != "yes") throw base::InputError("nothing was deleted");
}

std::filesystem::path keep_copy(const std::filesystem::path& folder, const archive::WordAnswers& answers,
                                const breeding::Lessons& lessons) {
    using std::chrono::system_clock;
    const auto now = std::chrono::time_point_cast<std::chrono::milliseconds>(system_clock::now());
    auto copy = folder / backup::dated_name(folder, "words.forgotten", now, ".json");
    // Answers that are gone, with a damaged state file say, may still be in what was learnt of them.
    const auto said = breeding::lessons_from(answers.readable);
    base::write_file(copy, to_json(breeding::Lessons{lessons.curator, said.empty() ? lessons.visitors : said}));
    archive::give_to_owner_of(folder, copy);
    return copy;
}

int forget(const Options& options) {
    const std::filesystem::path folder = site::existing_state_folder(options.state);
    const auto lock = backup::hold_state(folder, "quadrat words forget");
    const archive::WordAnswers answers = archive::word_answers_in(folder);
    const breeding::Lessons lessons = learning::site_words(folder).lessons;
    const std::size_t count = answers.readable.size() + static_cast<std::size_t>(answers.unreadable);
    const breeding::Taste taste = learning::site_taste(folder);
    const bool has_taste = taste.chosen != breeding::Taste{}.chosen;
    if (count == 0 && lessons.visitors.empty() && !has_taste) {
        fmt::print("visitors have said nothing yet: there is nothing to forget\n");
        return 0;
    }
    require_consent(options, count);
    // Visits that nobody counted yet are forgotten too.
    learning::keep_site_taste(folder, {{}, std::max(taste.since, learning::last_visit_in(folder))});
    if (has_taste) fmt::print("what visitors end up with is forgotten: all named scenes are as likely again\n");
    if (count == 0 && lessons.visitors.empty()) return 0;
    const std::filesystem::path copy = keep_copy(folder, answers, lessons);
    archive::forget_word_answers_in(folder);
    if (!lessons.visitors.empty()) learning::keep_site_words(folder, {lessons.curator, {}});
    // The map of before knows them too.
    std::error_code ignored;
    std::filesystem::remove(folder / "words.previous.json", ignored);
    fmt::print("{} answers are forgotten; {}\n", count,
               lessons.curator.empty() ? "the map is the default one" : "the map keeps what its curator taught");
    if (answers.unreadable > 0) fmt::print("{} of them could not be read, and are in no copy\n", answers.unreadable);
    fmt::print(
        "what they had taught is in {}: quadrat words train FILE learns it again; delete it to forget for good\n",
        copy.string());
    return 0;
}

void add_own(const Command& command, const std::shared_ptr<Options>& options) {
    const Command own = command.add_subcommand("own", "What a word of one's own means, told by ten scenes or more");
    own.set_footer(
        "FILE is {\"quadrat\":\"own word\",\"version\":1,\"name\":\"spooky\",\"aspect\":\"sky\",\"scenes\":[…]} with "
        "ten "
        "scenes or more,\neach {\"value\":0.8,\"words\":{\"misty\":0.5,…}} or "
        "{\"value\":-0.4,\"parameters\":{\"haze.distance_m\":900,…}}; values from -1 to 1.");
    own.add_option("FILE", options->files, "Scenes, and how far the word suits each").required().takes(1);
    own.add_option("--value", options->value, "How much of it").between(-1.0, 1.0).shows_default();
    own.add_option("-o,--output", options->output, "SCENE.json, the scene it then asks for").tells_default("none");
    own.does([options] { return tell_own(*options); });
}

// What only looks.
void add_looking(const Command& words, const std::shared_ptr<Options>& options) {
    const Command shown = words.add_subcommand("show", "Every word with its two ends, and how well the map knows them");
    shown.add_flag("--scenes", options->is_all, "Every described scene too: its reach, and what is left over of it");
    shown.does([options] { return show(*options); });
    const Command reach = words.add_subcommand(
        "reach", "How far picks move each parameter, and how often each kind is offered, where anybody picks anything");
    reach.add_option("--visits", options->visits, "To look through").between(1, 10000).shows_default();
    reach.add_option("--offers", options->offers, "In each").between(1, 100).shows_default();
    reach.add_flag("--all", options->is_all, "A line for every parameter and kind, not only for what falls short");
    reach.does([options] { return tell_reach(*options); });
    const Command sheet = words.add_subcommand("sheet", "A picture with a row a word, from one end to the other");
    sheet.add_option("-o,--output", options->output, "NAME.png or NAME.exr").required();
    sheet.add_option("--size", options->size, "Of each picture, in pixels").shows_default();
    sheet.add_option("--steps", options->steps, "Pictures a row").between(2, 21).shows_default();
    sheet.add_option("--seed", options->seed, "Names the places").shows_default();
    sheet.does([options] { return draw_sheet(*options); });
    const Command asked = words.add_subcommand(
        "ask", "Landscapes spread evenly over the words (Halton), to be described: NAME.json for train, and NAME.png");
    asked.add_option("-o,--output", options->output, "NAME.json").required();
    asked.add_option("--aspect", options->aspect, "trees, land or sky").among({"trees", "land", "sky"}).shows_default();
    asked.add_option("--count", options->count, "Landscapes").between(1, 400).shows_default();
    asked.add_option("--first", options->first, "Go on after so many that were asked before").shows_default();
    asked.add_option("--size", options->size, "Of each picture, in pixels").shows_default();
    asked.does([options] { return ask(*options); });
}

}  // namespace

void add_words(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command =
        program.add_subcommand("words", "The words that wishes are held in, and what they look like");
    command.requires_subcommand();
    command.shares_options();  // its options may stand after a subcommand too
    command.add_option("--language", options->language, "Of their ends: ar, de, en, es, … (quadrat languages)")
        .refused_by([](const std::string& code) {
            const auto codes = genome::language_codes();
            const std::string_view spoken = std::string_view(code).substr(0, code.find_first_of("-_."));
            if (std::ranges::find(codes, spoken) != codes.end()) return std::string();
            return fmt::format("{} is not spoken here; there are {}", code, fmt::join(codes, ", "));
        })
        .shows_default();
    command.add_option("--state", options->state, "The exhibit's state folder, for the map that its site has trained")
        .tells_default("show, sheet, own: the map that comes along; others: the service's, else the user's");
    add_looking(command, options);
    const Command trained =
        command.add_subcommand("train", "Learn from what visitors said, and from files, with the exhibit stopped");
    trained.add_option("FILE", options->files, "Scenes described by a curator, instead of those taught before")
        .tells_default("none");
    trained.add_flag("--anyway", options->is_anyway, "Also where scenes could be told from one another less well");
    trained.does([options] { return train(*options); });
    add_own(command, options);
    const Command exported =
        command.add_subcommand("export", "Write what visitors and the curator taught, to train from");
    exported.add_option("-o,--output", options->output, "FILE.json").required();
    exported.does([options] { return export_lessons(*options); });
    const Command axes = command.add_subcommand(
        "axes", "Measure by pictures along which axes scenes of the same words still differ; takes minutes");
    axes.add_option("-o,--output", options->output, "A folder for trees.json, land.json and sky.json")
        .required()
        .is_folder();
    axes.does([options] { return measure_axes(options->output); });
    const Command forgotten = command.add_subcommand(
        "forget", "Delete what visitors said, and what was learnt of it, with the exhibit stopped; a dated copy stays");
    forgotten.add_flag("--yes", options->is_sure, "Without being asked");
    forgotten.does([options] { return forget(*options); });
}

}  // namespace quadrat::commands
