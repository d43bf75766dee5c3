// SPDX-License-Identifier: Apache-2.0
// The README's first command, on the tree that is being tested. Other build folders than its own are left alone.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "journeys/quadrat_program.hpp"

namespace {

using namespace quadrat::tests;

bool is_the_default_build() {
    return std::filesystem::path(QUADRAT_BINARY_DIR) == std::filesystem::path(QUADRAT_SOURCE_DIR) / "build";
}

TEST(Deploy, RunBuildsStartsTheExhibitAndSaysWhereThePicturesAre) {
    if (!is_the_default_build()) return;  // deploy/run would build there; the sanitizers' folders have no such command
    const TemporaryFolder folder;
    const Ended ended = run({QUADRAT_SOURCE_DIR "/deploy/run", "--display", "auto", "--rounds", "1", "--size",
                             "320x180", "--state", "state"},
                            folder);
    ASSERT_EQ(ended.status, 0) << ended.out << ended.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "quadrat-pictures" / "contact-sheet.png")) << ended.err;
    EXPECT_NE(ended.out.find("quadrat-pictures"), std::string::npos);
}

TEST(Deploy, RunPassesHelpThrough) {
    if (!is_the_default_build()) return;
    const TemporaryFolder folder;
    const Ended ended = run({QUADRAT_SOURCE_DIR "/deploy/run", "--help"}, folder);
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("--capture"), std::string::npos);
}

}  // namespace
