// SPDX-License-Identifier: Apache-2.0
#include "kiosk/state_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "kiosk/commands/learn_buttons.hpp"
#include "support/process.hpp"

namespace quadrat::kiosk {
namespace {

namespace fs = std::filesystem;

TEST(StateFolder, OfWhoTendsAnExhibitIsTheServicesWhereThereIsOne) {
    const tests::TemporaryFolder machine;
    const ServiceFolders service{machine / "state", machine / "run"};
    EXPECT_EQ(tended_state_folder("", service), state_folder("")) << "no service is installed";
    fs::create_directory(service.state);
    EXPECT_EQ(tended_state_folder("", service), service.state);
    EXPECT_EQ(tended_state_folder("elsewhere", service), "elsewhere");
}

TEST(StateFolder, WhoAsksByHandSeesTheServiceUnlessAnotherExhibitIsNamed) {
    const tests::TemporaryFolder machine;
    const ServiceFolders service{machine / "state", machine / "run"};
    EXPECT_EQ(watched_folder(machine / "other", service), machine / "other");
    fs::create_directory(service.state);
    fs::create_directory(service.runtime);
    EXPECT_EQ(watched_folder("", service), service.runtime);
    EXPECT_EQ(watched_folder(service.state / "", service), service.runtime)
        << "named, it is the service's all the same";
    EXPECT_EQ(watched_folder(machine / "other", service), machine / "other");
}

TEST(StateFolder, WhoTendsAnExhibitReadsTheSettingsThatTheServiceReads) {
    const tests::TemporaryFolder machine;
    const ServiceFolders service{machine / "state", machine / "run", machine / "site.toml"};
    EXPECT_EQ(tended_configuration("", "", service), "") << "no service is installed: the defaults are meant";
    machine.write("site.toml", "# the defaults\n");
    EXPECT_EQ(tended_configuration("", "", service), service.configuration);
    EXPECT_EQ(tended_configuration("", service.state, service), "") << "of that name there is none yet";
    fs::create_directory(service.state);
    EXPECT_EQ(tended_configuration("", service.state, service), service.configuration);
    EXPECT_EQ(tended_configuration("mine.toml", "", service), "mine.toml");
    EXPECT_EQ(tended_configuration("", machine / "other", service), "") << "another exhibit, with settings of its own";
    fs::remove(service.configuration);
    EXPECT_EQ(tended_configuration("", "", service), service.configuration) << "lost: that is what is to be found";
}

TEST(LearnButtons, WhatRootLearnsTheServiceMayRead) {
    const tests::TemporaryFolder state;
    const mode_t before = ::umask(077);
    commands::keep_mappings(state / "buttons.map", std::vector<firmware_io::hid::HidMapping>{{0x79, 6, "", "", {}}});
    ::umask(before);
    EXPECT_EQ(fs::status(state / "buttons.map").permissions(), fs::perms{0644});
    EXPECT_EQ(firmware_io::hid::read_mappings(state / "buttons.map").size(), 1U);
}

}  // namespace
}  // namespace quadrat::kiosk
