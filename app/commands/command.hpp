// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

// What a command tells the command line of itself. Handles over CLI11, whose headers take a compiler longer than most
// commands do: command.cpp includes them, and the few that look at the whole line. What a handle names belongs to the
// program and outlives all parsing; copies name the same.
namespace quadrat::commands {

// What to do when a command was chosen: returns the exit status, and throws InputError for bad input.
using Action = std::function<int()>;

// Refuses a value by a sentence; "": it is fine.
using Refusal = std::function<std::string(const std::string&)>;

class Option {
  public:
    explicit Option(CLI::Option& option) : option_(&option) {}

    Option required() const;
    // What it is where it is left out: what its variable holds now, or in words.
    Option shows_default() const;
    Option tells_default(const std::string& words) const;

    template <typename Number>
    Option between(Number low, Number high) const;
    Option among(const std::vector<std::string>& words) const;
    Option among(std::initializer_list<int> numbers) const;
    Option is_folder() const;  // that exists
    Option refused_by(const Refusal& refusal) const;

    Option takes(int values) const;
    Option takes_one_each_time() const;  // however often it is given
    Option keeps_all() const;            // of the values that it is given
    Option needs(const Option& other) const;
    Option excludes(const Option& other) const;

  private:
    CLI::Option* option_;
};

class Command {
  public:
    // chosen: where the action goes of the command that was named.
    Command(CLI::App& app, Action& chosen) : app_(&app), chosen_(&chosen) {}

    Command add_subcommand(const std::string& name, const std::string& description) const;
    // names: as "-o,--output"; a word without a dash is told by its place. value: read when the line is parsed; of the
    // types that command.cpp lists.
    template <typename Value>
    Option add_option(const std::string& names, Value& value, const std::string& description) const;
    Option add_flag(const std::string& names, bool& is_given, const std::string& description) const;

    void does(Action action) const;
    void does_alone(Action action) const;  // where none of its subcommands was named
    void requires_subcommand() const;
    void shares_options() const;  // they may stand after a subcommand too
    void set_footer(const std::string& text) const;

    CLI::App& app() const { return *app_; }

  private:
    CLI::App* app_;
    Action* chosen_;
};

}  // namespace quadrat::commands
