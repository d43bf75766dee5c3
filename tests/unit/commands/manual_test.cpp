// SPDX-License-Identifier: Apache-2.0
#include "commands/manual_pages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include "commands/commands.hpp"

namespace quadrat::commands {
namespace {

using testing::HasSubstr;

class Manual : public testing::Test {
  protected:
    Manual() { add_all(program, chosen); }

    CLI::App program{"What it is", "quadrat"};
    Action chosen;
};

void expect_defaults(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        EXPECT_FALSE(option->get_description().empty()) << command.get_name() << " " << option->get_name();
        EXPECT_TRUE(!takes_a_value(*option) || option->get_required() || !option->get_default_str().empty())
            << command.get_name() << " " << option->get_name() << " does not say what it is where it is left out";
    }
    for (const CLI::App* one : command.get_subcommands([](const CLI::App*) { return true; })) expect_defaults(*one);
}

TEST_F(Manual, EveryOptionSaysWhatItIsWithout) { expect_defaults(program); }

TEST_F(Manual, HelpNamesDefaults) {
    EXPECT_THAT(program.get_subcommand("field")->help(), HasSubstr("[513]"));
    EXPECT_THAT(program.get_subcommand("render")->help(), HasSubstr("[the scene's, else 1280x720]"));
}

TEST_F(Manual, APageHasEveryOptionWithItsDefaultAndNoLineThatManMisreads) {
    for (const CLI::App* one : program.get_subcommands([](const CLI::App*) { return true; })) {
        const std::string page = man_page(*one);
        EXPECT_THAT(page, testing::StartsWith(".TH "));
        std::size_t entries = 0;
        for (auto at = page.find(".TP\n"); at != std::string::npos; at = page.find(".TP\n", at + 1)) ++entries;
        EXPECT_GE(entries, one->get_options().size()) << one->get_name();
    }
    const std::string page = man_page(*program.get_subcommand("field"));
    EXPECT_THAT(page, HasSubstr(".B \\-\\-size \\fRINT"));
    EXPECT_THAT(page, HasSubstr("Default: 513"));
    EXPECT_THAT(page, HasSubstr(".B \\-\\-relief\n")) << "a flag has no type";
    EXPECT_THAT(man_page(*program.get_subcommand("words")), HasSubstr(".SS quadrat words sheet"));
}

TEST_F(Manual, CompletionKnowsSubcommandsOptionsAndValues) {
    const std::string script = bash_completion(program);
    EXPECT_THAT(script, HasSubstr("\"quadrat words sheet\")"));
    EXPECT_THAT(script, HasSubstr("\"quadrat run --display\") words=\"auto kms window headless\""));
    EXPECT_THAT(script, HasSubstr("complete -o default -F _quadrat quadrat"));
}

}  // namespace
}  // namespace quadrat::commands
