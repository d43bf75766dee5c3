// SPDX-License-Identifier: Apache-2.0
// The room `commands`: the command line, one file a subcommand. What a command does lives in the rooms below; here it
// is asked for, and its mistakes are told to people.
#pragma once
#include "commands/command.hpp"

// One file a subcommand. Each adds itself to the command line, and says what to do when it was chosen.
namespace quadrat::commands {

void add_run(const Command& program);
void add_breed(const Command& program);
void add_render(const Command& program);
void add_code(const Command& program);
void add_postcard(const Command& program);
void add_cards(const Command& program);
void add_sound(const Command& program);
void add_languages(const Command& program);
void add_export(const Command& program);
void add_lsystem(const Command& program);
void add_skeleton(const Command& program);
void add_lots(const Command& program);
void add_facade(const Command& program);
void add_field(const Command& program);
void add_tiles(const Command& program);
void add_simulate(const Command& program);
void add_words(const Command& program);
void add_bench(const Command& program);
void add_doctor(const Command& program);
void add_shot(const Command& program);
void add_state(const Command& program);
void add_desk(const Command& program);
void add_report(const Command& program);
void add_publish(const Command& program);
void add_projector(const Command& program);
void add_man(const Command& program);
void add_completion(const Command& program);

// All of them. Every option that takes a value, and need not be given, says what it is without: shows_default, or
// tells_default in words.
void add_all(CLI::App& app, Action& chosen);

}  // namespace quadrat::commands
