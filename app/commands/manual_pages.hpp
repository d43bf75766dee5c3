// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

// What the command line says of itself, for man and for bash: made from the same options that are parsed.
namespace quadrat::commands {

// Whether something follows it: a flag's name says all.
bool takes_a_value(const CLI::Option& option);

// "quadrat-run", the name of its page; "quadrat" of the program's own.
std::string page_name(const CLI::App& command);

// Its page in man(7)'s language, subcommands of its own included. Nothing in it depends on the time or the machine.
std::string man_page(const CLI::App& command);

struct ManualPage {
    std::string command;  // "run"
    std::string name;     // page_name()
    std::string text;     // man_page()
};
// The program's own, then one of each of its commands.
std::vector<ManualPage> manual_pages(const CLI::App& program);

// For bash's complete: subcommands, options, and the values of those that have only a few; file names for others.
std::string bash_completion(const CLI::App& program);

}  // namespace quadrat::commands
