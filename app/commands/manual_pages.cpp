// SPDX-License-Identifier: Apache-2.0
#include "commands/manual_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <vector>

namespace quadrat::commands {
namespace {

std::vector<const CLI::App*> subcommands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string words_of(const CLI::App& command) {  // "quadrat words sheet"
    const CLI::App* parent = command.get_parent();
    return parent == nullptr ? command.get_name() : words_of(*parent) + " " + command.get_name();
}

// man(7) takes a line that begins with . or ' for one of its own, and a - for a hyphen.
std::string roff(const std::string& text) {
    std::string out;
    bool begins_line = true;
    for (const char c : text) {
        if (begins_line && (c == '.' || c == '\'')) out += "\\&";
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else
            out += c;
        begins_line = c == '\n';
    }
    return out;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string option_entry(const CLI::Option& option) {
    const std::string type = takes_a_value(option) ? option.get_type_name() : "";
    std::string entry = fmt::format(".TP\n.B {}", roff(option.get_name(option.get_positional(), true)));
    entry += type.empty() ? "\n" : fmt::format(" \\fR{}\n", roff(type));
    entry += roff(option.get_description());
    if (option.get_required()) entry += "\n.br\nIt must be given.";
    if (!option.get_default_str().empty()) entry += "\n.br\nDefault: " + roff(option.get_default_str());
    return entry + "\n";
}

std::string option_entries(const CLI::App& command) {
    std::string entries;
    for (const CLI::Option* option : command.get_options()) entries += option_entry(*option);
    return entries;
}

std::string synopsis_of(const CLI::App& command) {
    std::string line = fmt::format(".B {}\n[options]", roff(words_of(command)));
    for (const CLI::Option* option : command.get_options())
        if (option->get_positional()) {
            const std::string name = roff(option->get_name(true));
            line += option->get_required() ? " " + name : " [" + name + "]";
        }
    if (!subcommands_of(command).empty()) line += " subcommand";
    return line + "\n";
}

// A page of its own for each of the program's; a section for each of a command's.
std::string subcommands_section(const CLI::App& command) {
    if (subcommands_of(command).empty()) return "";
    std::string section = ".SH SUBCOMMANDS\n";
    for (const CLI::App* one : subcommands_of(command)) {
        if (command.get_parent() == nullptr)
            section +=
                fmt::format(".TP\n.BR {} (1)\n{}\n", roff(page_name(*one)), roff(first_line(one->get_description())));
        else
            section +=
                fmt::format(".SS {}\n{}\n{}", roff(words_of(*one)), roff(one->get_description()), option_entries(*one));
    }
    return section;
}

std::vector<std::string> long_and_short_names(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    return names;
}

// CLI11 tells of an option's few values in its type: TEXT:{auto,kms}.
std::string values_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const std::size_t begin = type.find('{');
    const std::size_t end = type.find('}', begin == std::string::npos ? 0 : begin);
    if (begin == std::string::npos || end == std::string::npos) return "";
    std::string values = type.substr(begin + 1, end - begin - 1);
    std::ranges::replace(values, ',', ' ');
    return values;
}

struct Completion {
    std::vector<std::string> commands;  // "quadrat run"
    std::string after_option;           // branches of a case: what may stand after an option
    std::string words;                  // branches of a case: what may stand in a command

    void take(const CLI::App& command) {
        const std::string path = words_of(command);
        std::vector<std::string> known;
        std::vector<std::string> anything;
        for (const CLI::App* one : subcommands_of(command)) known.push_back(one->get_name());
        for (const CLI::Option* option : command.get_options()) {
            const std::string values = values_of(*option);
            if (option->get_positional() && !values.empty()) known.push_back(values);
            for (const std::string& name : long_and_short_names(*option)) {
                known.push_back(name);
                if (!takes_a_value(*option)) continue;
                const std::string pattern = fmt::format("\"{} {}\"", path, name);
                if (values.empty())
                    anything.push_back(pattern);
                else
                    after_option += fmt::format("        {}) words=\"{}\" ;;\n", pattern, values);
            }
        }
        if (!anything.empty()) after_option += fmt::format("        {}) return ;;\n", fmt::join(anything, " | "));
        words += fmt::format("        \"{}\") words=\"{}\" ;;\n", path, fmt::join(known, " "));
        for (const CLI::App* one : subcommands_of(command)) {
            commands.push_back(fmt::format("\"{}\"", words_of(*one)));
            take(*one);
        }
    }
};

}  // namespace

bool takes_a_value(const CLI::Option& option) {
    return option.get_type_size() != 0 && option.get_items_expected_max() != 0;
}

std::string page_name(const CLI::App& command) {
    std::string name = words_of(command);
    std::ranges::replace(name, ' ', '-');
    return name;
}

std::string man_page(const CLI::App& command) {
    const CLI::App* program = &command;
    while (program->get_parent() != nullptr) program = program->get_parent();
    const std::string name = page_name(command);
    std::string title = name;
    for (char& c : title) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    std::string page = fmt::format(".TH {} 1 \"\" \"{}\" \"Quadrat\"\n", roff(title), roff(program->version()));
    page += fmt::format(".SH NAME\n{} \\- {}\n", roff(name), roff(first_line(command.get_description())));
    page += ".SH SYNOPSIS\n" + synopsis_of(command);
    page += fmt::format(".SH DESCRIPTION\n{}\n", roff(command.get_description()));
    if (!command.get_footer().empty()) page += fmt::format(".PP\n{}\n", roff(command.get_footer()));
    page += ".SH OPTIONS\n" + option_entries(command) + subcommands_section(command);
    page +=
        ".SH EXIT STATUS\n0: success. 2: bad usage, bad input, or hardware missing at start, with one line on standard "
        "error that says what mends it.\n";
    if (&command != program) page += fmt::format(".SH SEE ALSO\n.BR {} (1)\n", program->get_name());
    return page;
}

std::vector<ManualPage> manual_pages(const CLI::App& program) {
    std::vector<ManualPage> pages{{program.get_name(), page_name(program), man_page(program)}};
    for (const CLI::App* one : subcommands_of(program))
        pages.push_back({one->get_name(), page_name(*one), man_page(*one)});
    return pages;
}

std::string bash_completion(const CLI::App& program) {
    Completion completion;
    completion.take(program);
    return fmt::format(
        R"(# bash completion for {0}; made by: {0} completion bash
_{0}() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} path={0} words= i
    COMPREPLY=()
    for ((i = 1; i < COMP_CWORD; i++)); do
        case "$path ${{COMP_WORDS[i]}}" in
        {1}) path="$path ${{COMP_WORDS[i]}}" ;;
        esac
    done
    case "$path ${{COMP_WORDS[COMP_CWORD - 1]}}" in
{2}    esac
    [ -n "$words" ] || case "$path" in
{3}    esac
    COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o default -F _{0} {0}
)",
        program.get_name(), fmt::join(completion.commands, " | "), completion.after_option, completion.words);
}

}  // namespace quadrat::commands
