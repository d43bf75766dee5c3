// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include "commands/commands.hpp"

namespace quadrat::commands {
namespace {

// As newer versions of CLI11 do it: apart from the type, in brackets.
class Help final : public CLI::Formatter {
    std::string make_option_opts(const CLI::Option* option) const override {
        std::string text = CLI::Formatter::make_option_opts(option);
        const std::string value = option->get_default_str();
        const std::size_t at = text.find("=" + value);
        if (!value.empty() && at != std::string::npos) text.replace(at, value.size() + 1, " [" + value + "]");
        return text;
    }
};

}  // namespace

void add_all(CLI::App& app, Action& chosen) {
    app.formatter(std::make_shared<Help>());
    for (const auto add :
         {add_run,       add_breed,    add_render,  add_code,      add_postcard, add_cards,     add_sound,
          add_languages, add_export,   add_lsystem, add_skeleton,  add_lots,     add_facade,    add_field,
          add_tiles,     add_simulate, add_words,   add_bench,     add_doctor,   add_shot,      add_state,
          add_report,    add_desk,     add_publish, add_projector, add_man,      add_completion})
        add(Command(app, chosen));
}

}  // namespace quadrat::commands
