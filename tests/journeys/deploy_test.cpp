// SPDX-License-Identifier: Apache-2.0
// The README's first command, on the tree that is being tested; part of the tests in its own build folder alone.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "journeys/quadrat_program.hpp"

namespace {

using namespace quadrat::tests;

TEST(Deploy, RunBuildsStartsTheExhibitAndSaysWhereThePicturesAre) {
    const TemporaryFolder folder;
    const Ended ended = run({QUADRAT_SOURCE_DIR "/deploy/run", "--display", "auto", "--rounds", "1", "--size",
                             "320x180", "--state", "state"},
                            folder);
    ASSERT_EQ(ended.status, 0) << ended.out << ended.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "quadrat-pictures" / "contact-sheet.png")) << ended.err;
    EXPECT_NE(ended.out.find("quadrat-pictures"), std::string::npos);
}

TEST(Deploy, RunPassesHelpThrough) {
    const TemporaryFolder folder;
    const Ended ended = run({QUADRAT_SOURCE_DIR "/deploy/run", "--help"}, folder);
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("--capture"), std::string::npos);
}

}  // namespace
