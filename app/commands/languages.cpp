// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text_file.hpp"
#include "commands/commands.hpp"
#include "genome/json_text.hpp"
#include "genome/language_po.hpp"
#include "genome/speech.hpp"
#include "render/coverage.hpp"

namespace quadrat::commands {
namespace {

struct Options {
    std::string code;
    std::string file;
    std::string output;
};

// Every letter that the language may show.
std::string all_said(const genome::Language& language) {
    std::string said = language.name();
    for (const std::string_view key : genome::kPrompts) said.append(language.prompt(key)).append("\n");
    for (const genome::Word& word : genome::vocabulary())
        for (const std::string& answer : language.answers(word.id)) said.append(answer).append("\n");
    for (const genome::Parameter& p : genome::parameter_table())
        for (const bool is_more : {false, true}) said.append(language.detail(p.id, is_more)).append("\n");
    return said;
}

std::size_t texts_in(const nlohmann::json& value) {
    if (value.is_string()) return 1;
    std::size_t count = 0;
    for (const auto& inner : value) count += texts_in(inner);
    return count;
}

std::size_t texts_in_file(std::string_view json) { return texts_in(genome::parse_json(json, "languages")); }

int list() {
    const std::size_t all = texts_in_file(genome::language_json("en"));
    for (const std::string_view code : genome::language_codes()) {
        const genome::Language& language = genome::language(code);
        const std::string missing = render::letters_without_font(all_said(language));
        fmt::print("{:<4}{:>4} of {} texts  {}{}{}\n", code, texts_in_file(genome::language_json(code)), all,
                   language.name(), language.reads_right_to_left() ? "  (from right to left)" : "",
                   missing.empty() ? "" : fmt::format("  no installed font has {}", missing));
    }
    return 0;
}

int write(const Options& options) {
    const bool is_json = std::filesystem::path(options.output).extension() == ".json";
    if (is_json && genome::language_json(options.code).empty())
        throw base::InputError(fmt::format("{} is not spoken here; write a .po to begin with it", options.code));
    const std::string text = is_json ? std::string(genome::language_json(options.code)) : genome::po_of(options.code);
    if (options.output.empty()) {
        fmt::print("{}", text);
        return 0;
    }
    base::require_ending(options.output, {".po", ".json"}, "a language");
    base::write_file(options.output, text);
    return 0;
}

// What a file would have the exhibit say; all that is wrong with it, or how much of it there is.
int check(const Options& options) {
    const std::string text = base::read_text(options.file, base::kJsonLimits);
    const bool is_po = std::filesystem::path(options.file).extension() == ".po";
    const std::string json = is_po ? genome::json_of_po(text, options.file) : text;
    const genome::Language language = genome::Language::from_json(json, options.file);
    const std::size_t all = texts_in_file(genome::language_json("en"));
    const std::size_t has = texts_in_file(json);
    fmt::print("{}: {}, {} of {} texts\n", options.file, language.name(), has, all);
    if (has < all) fmt::print("the other {} are spoken in English\n", all - has);
    const std::string missing = render::letters_without_font(all_said(language));
    if (!missing.empty()) throw base::InputError(fmt::format("{}: no installed font has {}", options.file, missing));
    if (!options.output.empty()) {
        base::require_ending(options.output, {".json"}, "a language");
        base::write_file(options.output, json);
    }
    return 0;
}

}  // namespace

void add_languages(const Command& program) {
    auto options = std::make_shared<Options>();
    const Command command =
        program.add_subcommand("languages", "What the exhibit says, for translators; alone: which there are");
    command.does_alone([] { return list(); });
    const Command exported = command.add_subcommand("export", "Write one for a translator's tools");
    exported.add_option("code", options->code, "en, de, …; or of one that is not spoken yet").required();
    exported.add_option("-o,--output", options->output, "FILE.po, or FILE.json as the program has it")
        .tells_default("PO, on the terminal");
    exported.does([options] { return write(*options); });
    const Command checked = command.add_subcommand("check", "Read a file as [visit] language_folder would be");
    checked.add_option("file", options->file, "CODE.po or CODE.json").required();
    checked.add_option("-o,--output", options->output, "Write it as FILE.json").tells_default("none");
    checked.does([options] { return check(*options); });
}

}  // namespace quadrat::commands
