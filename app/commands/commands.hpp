// SPDX-License-Identifier: Apache-2.0
// The room `commands`: the command line, one file a subcommand. What a command does lives in the rooms below; here it
// is asked for, and its mistakes are told to people.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <memory>

// One file a subcommand. Each adds itself to the command line and sets what to do when it was chosen; that returns the
// exit status, and throws InputError for bad input.
namespace quadrat::commands {

using Action = std::function<int()>;

void add_run(CLI::App& app, Action& chosen);
void add_breed(CLI::App& app, Action& chosen);
void add_render(CLI::App& app, Action& chosen);
void add_code(CLI::App& app, Action& chosen);
void add_postcard(CLI::App& app, Action& chosen);
void add_cards(CLI::App& app, Action& chosen);
void add_sound(CLI::App& app, Action& chosen);
void add_languages(CLI::App& app, Action& chosen);
void add_export(CLI::App& app, Action& chosen);
void add_lsystem(CLI::App& app, Action& chosen);
void add_skeleton(CLI::App& app, Action& chosen);
void add_lots(CLI::App& app, Action& chosen);
void add_facade(CLI::App& app, Action& chosen);
void add_field(CLI::App& app, Action& chosen);
void add_tiles(CLI::App& app, Action& chosen);
void add_simulate(CLI::App& app, Action& chosen);
void add_words(CLI::App& app, Action& chosen);
void add_bench(CLI::App& app, Action& chosen);
void add_doctor(CLI::App& app, Action& chosen);
void add_shot(CLI::App& app, Action& chosen);
void add_state(CLI::App& app, Action& chosen);
void add_desk(CLI::App& app, Action& chosen);
void add_report(CLI::App& app, Action& chosen);
void add_publish(CLI::App& app, Action& chosen);
void add_projector(CLI::App& app, Action& chosen);
void add_man(CLI::App& app, Action& chosen);
void add_completion(CLI::App& app, Action& chosen);

// All of them. Every option that takes a value, and need not be given, says what it is without: capture_default_str, or
// default_str in words.
void add_all(CLI::App& app, Action& chosen);

}  // namespace quadrat::commands
