// SPDX-License-Identifier: Apache-2.0
#include "commands/learn_buttons.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "support/process.hpp"

namespace quadrat::commands {
namespace {

namespace fs = std::filesystem;

TEST(LearnButtons, WhatRootLearnsTheServiceMayRead) {
    const tests::TemporaryFolder state;
    const mode_t before = ::umask(077);
    keep_mappings(state / "buttons.map", std::vector<firmware_io::hid::HidMapping>{{0x79, 6, "", "", {}}});
    ::umask(before);
    EXPECT_EQ(fs::status(state / "buttons.map").permissions(), fs::perms{0644});
    EXPECT_EQ(firmware_io::hid::read_mappings(state / "buttons.map").size(), 1U);
}

}  // namespace
}  // namespace quadrat::commands
