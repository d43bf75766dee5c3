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

// "set -e" has no say where a caller asks how it ended.
TEST(Deploy, ABuildThatFailsIsSaidToHaveFailedToWhoeverAsks) {
    const TemporaryFolder folder;
    for (const auto& [step, said] : {std::pair{"-S", ""}, {"--build", "ended with 1\n"}, {"neither", "built\n"}}) {
        const Ended ended =
            run({"bash", "-c",
                 ". " QUADRAT_SOURCE_DIR "/deploy/common.sh; cmake() { [ \"$1\" != " + std::string(step) +
                     " ]; }; if configure_and_build there target -- -DA=B; then echo built; "
                     "else echo \"ended with $?\"; fi"},
                folder);
        EXPECT_EQ(ended.out, said) << ended.err;
        EXPECT_EQ(ended.status, std::string(step) == "-S" ? 2 : 0) << "what cannot be configured ends all of it";
    }
}

// deploy/test --deep with stages that pass at once, so many seconds after its start: its last line.
std::string last_line_of_deep_tests_after(int seconds) {
    const TemporaryFolder folder;
    const Ended ended = run({"bash", "-c",
                             ". " QUADRAT_SOURCE_DIR "/deploy/test; "
                             "for passed in install_packages under_sanitizer fuzz gpu tidy browser run_ctest; do eval "
                             "\"$passed() { :; }\"; done; "
                             "SECONDS=" +
                                 std::to_string(seconds) + "; deeply"},
                            folder);
    EXPECT_TRUE(succeeds(ended));
    const auto lines = lines_of(ended.out);
    return lines.empty() ? "" : lines.back();
}

TEST(Deploy, DeepTestsSayInTheirLastLineWhatTheyLeftOut) {
    const std::string in_time = last_line_of_deep_tests_after(1200);
    EXPECT_EQ(in_time.find("NOT RUN"), std::string::npos) << in_time;
    EXPECT_TRUE(in_time.starts_with("== all of it passed ("));
    const std::string late = last_line_of_deep_tests_after(3100);
    for (const char* left_out : {"landscapes and breeding under ASan", "journeys and pictures under ASan"})
        EXPECT_NE(late.find(left_out), std::string::npos) << late;
    EXPECT_EQ(late.find("clang-tidy"), std::string::npos) << late;
    const std::string later = last_line_of_deep_tests_after(4000);
    for (const char* left_out :
         {"unit tests under ASan", "TSan", "clang-tidy", "in a browser", "an emulated exhibit machine"})
        EXPECT_NE(later.find(left_out), std::string::npos) << later;
}

}  // namespace
