// SPDX-License-Identifier: Apache-2.0
// The plug is pulled: whatever the moment, the exhibit opens again, with the generation that it showed last.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <regex>
#include <thread>

#include "journeys/quadrat_program.hpp"
#include "support/effort.hpp"

namespace {

using namespace quadrat::tests;

std::string endless_visit() {
    std::string script = "at 100ms press A\n";
    for (int i = 0; i < 60; ++i) script += "after 350ms press " + std::string(1, static_cast<char>('A' + i % 4)) + "\n";
    return script + "hold B for 1s\nwait 600s\n";
}

std::vector<std::string> exhibit_command() {
    return program({"run", "--config", "small.toml", "--display", "headless", "--size", "64x64", "--input",
                    "script:visit.script", "--state", "state", "--capture", "pictures", "--seed", "5"});
}

int last_round_shown(const std::string& log) {
    static const std::regex shown(R"(picture generation-\d+\.png of round (\d+))");
    int round = 0;
    for (std::sregex_iterator it(log.begin(), log.end(), shown), end; it != end; ++it) round = std::stoi((*it)[1]);
    return round;
}

// Until the log says so; the test's own time limit ends a wait for what never comes.
void wait_for(Process& process, const std::filesystem::path& log, const std::string& what) {
    using namespace std::chrono_literals;
    while (process.is_running() && contents_of(log).find(what) == std::string::npos) std::this_thread::sleep_for(5ms);
}

TEST(PowerCut, TheExhibitGoesOnWithTheGenerationItLastShowed) {
    const TemporaryFolder folder;
    folder.write("small.toml", "[picture]\nland_samples = 129\n");
    folder.write("visit.script", endless_visit());
    for (int cut = 0; cut < quadrat::tests::of(4); ++cut) {
        std::filesystem::remove_all(folder / "state");
        Process exhibit(exhibit_command(), folder.path());
        wait_for(exhibit, folder / "stderr.txt", "picture generation-0" + std::to_string(2 + cut % 3));
        exhibit.kill(SIGKILL);
        const int shown = last_round_shown(exhibit.wait().err);
        ASSERT_GE(shown, 2);
        Process again(exhibit_command(), folder.path());
        wait_for(again, folder / "stderr.txt", "taking up visit");
        again.kill(SIGKILL);
        const std::string log = again.wait().err;
        static const std::regex taken(R"(taking up visit 1 at round (\d+))");
        std::smatch match;
        ASSERT_TRUE(std::regex_search(log, match, taken)) << log;
        // One more may have been kept already, on its way to the screen.
        EXPECT_GE(std::stoi(match[1]), shown);
        EXPECT_LE(std::stoi(match[1]), shown + 1);
    }
}

// An exhibit learns from visits when it starts; one that was interrupted has not ended, however often it is.
TEST(PowerCut, TwiceInOneVisitItGoesOnAllTheSame) {
    const TemporaryFolder folder;
    folder.write("small.toml", "[picture]\nland_samples = 129\n");
    folder.write("visit.script", endless_visit());
    Process first(exhibit_command(), folder.path());
    wait_for(first, folder / "stderr.txt", "picture generation-02");
    first.kill(SIGKILL);
    ASSERT_GE(last_round_shown(first.wait().err), 2);
    for (int start = 0; start < 2; ++start) {
        folder.write("visit.script", "wait 600s\n");
        std::filesystem::remove(folder / "stderr.txt");  // what it holds is of the start before
        Process again(exhibit_command(), folder.path());
        wait_for(again, folder / "stderr.txt", "the four of round");
        again.kill(SIGKILL);
        EXPECT_THAT(again.wait().err, testing::HasSubstr("taking up visit 1 at round")) << "start " << start;
    }
}

TEST(PowerCut, ADamagedStateIsSetAsideAndThePublicIsLetIn) {
    const TemporaryFolder folder;
    folder.write("small.toml", "[picture]\nland_samples = 129\n");
    folder.write("visit.script", "at 1s press A\nafter 2s press B\n");
    std::filesystem::create_directory(folder / "state");
    folder.write("state/quadrat.db", "SQLite format 3\0 but not for long");
    const Ended ended = run(exhibit_command(), folder);
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.err.find("quadrat.db.damaged-"), std::string::npos) << ended.err;
    bool is_set_aside = false;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "state"))
        is_set_aside = is_set_aside || entry.path().filename().string().starts_with("quadrat.db.damaged-");
    EXPECT_TRUE(is_set_aside);
}

}  // namespace
