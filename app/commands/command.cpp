// SPDX-License-Identifier: Apache-2.0
#include "commands/command.hpp"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <utility>

namespace quadrat::commands {

Option Option::required() const { return Option(*option_->required()); }
Option Option::shows_default() const { return Option(*option_->capture_default_str()); }
Option Option::tells_default(const std::string& words) const { return Option(*option_->default_str(words)); }

template <typename Number>
Option Option::between(Number low, Number high) const {
    return Option(*option_->check(CLI::Range(low, high)));
}
template Option Option::between(int, int) const;
template Option Option::between(std::size_t, std::size_t) const;
template Option Option::between(float, float) const;
template Option Option::between(double, double) const;

Option Option::among(const std::vector<std::string>& words) const {
    return Option(*option_->check(CLI::IsMember(words)));
}
Option Option::among(std::initializer_list<int> numbers) const {
    return Option(*option_->check(CLI::IsMember(numbers)));
}
Option Option::is_folder() const { return Option(*option_->check(CLI::ExistingDirectory)); }
Option Option::refused_by(const Refusal& refusal) const {
    return Option(*option_->check(CLI::Validator([refusal](std::string& value) { return refusal(value); }, "")));
}

Option Option::takes(int values) const { return Option(*option_->expected(values)); }
Option Option::takes_one_each_time() const { return Option(*option_->allow_extra_args(false)); }
Option Option::keeps_all() const { return Option(*option_->take_all()); }
Option Option::needs(const Option& other) const { return Option(*option_->needs(other.option_)); }
Option Option::excludes(const Option& other) const { return Option(*option_->excludes(other.option_)); }

Command Command::add_subcommand(const std::string& name, const std::string& description) const {
    return {*app_->add_subcommand(name, description), *chosen_};
}

template <typename Value>
Option Command::add_option(const std::string& names, Value& value, const std::string& description) const {
    return Option(*app_->add_option(names, value, description));
}
template Option Command::add_option(const std::string&, std::string&, const std::string&) const;
template Option Command::add_option(const std::string&, int&, const std::string&) const;
template Option Command::add_option(const std::string&, std::size_t&, const std::string&) const;
template Option Command::add_option(const std::string&, float&, const std::string&) const;
template Option Command::add_option(const std::string&, double&, const std::string&) const;
template Option Command::add_option(const std::string&, std::optional<int>&, const std::string&) const;
template Option Command::add_option(const std::string&, std::optional<std::uint64_t>&, const std::string&) const;
template Option Command::add_option(const std::string&, std::optional<float>&, const std::string&) const;
template Option Command::add_option(const std::string&, std::vector<std::string>&, const std::string&) const;
template Option Command::add_option(const std::string&, std::vector<float>&, const std::string&) const;
template Option Command::add_option(const std::string&, std::vector<double>&, const std::string&) const;

Option Command::add_flag(const std::string& names, bool& is_given, const std::string& description) const {
    return Option(*app_->add_flag(names, is_given, description));
}

void Command::does(Action action) const {
    app_->callback([chosen = chosen_, action = std::move(action)] { *chosen = action; });
}

void Command::does_alone(Action action) const {
    app_->callback([app = app_, chosen = chosen_, action = std::move(action)] {
        if (app->get_subcommands().empty()) *chosen = action;
    });
}

void Command::requires_subcommand() const { app_->require_subcommand(1); }
void Command::shares_options() const { app_->fallthrough(); }
void Command::set_footer(const std::string& text) const { app_->footer(text); }

}  // namespace quadrat::commands
