// SPDX-License-Identifier: Apache-2.0
// What follows from a finale: the visit's family tree, a postcard on paper, a place among what hangs in Attract, a
// wall.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "journeys/quadrat_program.hpp"
#include "journeys/state_database.hpp"
#include "support/effort.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;

const std::string kSmall = "[picture]\nland_samples = 65\nalpha = 0.2\n";
const std::string kAddress = "https://museum.example/quadrat/";

std::string round_of(const std::string& a, const std::string& b, const std::string& c) {
    return "after 1500ms press " + a + "\nafter 1500ms press " + b + "\nafter 1500ms press " + c + "\n";
}

Ended play(const TemporaryFolder& folder, const std::string& settings, const std::string& script,
           const std::string& pictures) {
    folder.write("site.toml", kSmall + "[visit]\ndescribe_words = 0\n" + settings);
    folder.write("visit.script", script);
    return run(program({"run", "--config", "site.toml", "--display", "headless", "--size", "320x180", "--input",
                        "script:visit.script", "--state", "state", "--capture", pictures, "--seed", "7"}),
               folder);
}

TEST(FamilyTree, IsWalkedByTheButtonsAndLeadsBackToFourThatWereSeen) {
    const TemporaryFolder folder;
    const Ended ended = play(folder, "rounds = 3\n",
                             "at 2s press A\n" + round_of("A", "B", "C") + round_of("B", "B", "D") +
                                 round_of("C", "A", "A") +  // the finale of three rounds
                                 "after 4s press A\n"       // its family tree,
                                 "after 1s press A\n"       // the third four,
                                 "after 1s press A\n"       // the second:
                                 "after 1s press D\n" +     // on from there, another way
                                 round_of("D", "D", "D") +
                                 round_of("A", "B", "D") +
                                 "after 4s press A\nafter 1s press C\n"  // the finale before is in the tree too
                                 "after 1s press Back\nafter 4s press D\n",
                             "pictures");
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(count_of(ended.err, "the landscape they bred"), 2U) << ended.err;
    EXPECT_EQ(count_of(ended.err, "a visit begins"), 1U);
    EXPECT_EQ(count_of(ended.err, "the visit ends with its finale, after 3 rounds"), 1U) << ended.err;
    // The second four again, to the bit: of rounds 1, 2, 3 and then 2, 3.
    EXPECT_EQ(contents_of(folder / "pictures/generation-02.png"), contents_of(folder / "pictures/generation-04.png"));
    EXPECT_NE(contents_of(folder / "pictures/generation-03.png"), contents_of(folder / "pictures/generation-05.png"));
    EXPECT_NE(contents_of(folder / "pictures/finale-01.png"), contents_of(folder / "pictures/finale-02.png"));
    Database database(folder / "state" / "quadrat.db");
    EXPECT_EQ(database.number("SELECT count(*) FROM visit WHERE ending='finished' AND rounds=3"), 1);
    EXPECT_EQ(database.number("SELECT count(*) FROM generation WHERE round=3 AND deeds LIKE '% DDD'"), 1);
}

TEST(FamilyTree, IsWalkedWithOneButton) {
    const TemporaryFolder folder;
    const std::string at_a = "after 700ms press D\n";
    const Ended ended = play(folder, "rounds = 1\n[play]\nbuttons = \"one\"\npace_s = 1\n",
                             "at 2s press D\n" + at_a + at_a + at_a +
                                 "after 4000ms press D\n"  // the mark is on A again, past B and D: the family tree
                                 "after 700ms press D\n"   // its first four
                                 "after 2s press D\n"      // D, past B: on from there
                                 + at_a + at_a + at_a + "wait 90s\n",
                             "pictures");
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(count_of(ended.err, "the landscape they bred"), 2U) << ended.err;
    EXPECT_EQ(count_of(ended.err, "the visit ends with its finale, after 1 rounds"), 1U) << ended.err;
}

TEST(ABredLandscape, IsBredOnFromByItsButtonAndThatCounts) {
    const TemporaryFolder folder;
    const std::string visit = round_of("A", "B", "C") + "after 4s press D\n";
    const Ended ended =
        play(folder, "rounds = 1\n",
             "at 2s press A\n" + visit + "after 5s press D\n" + visit + "after 5s press A\n" + visit, "pictures");
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(count_of(ended.err, "the visit ends with its finale"), 3U) << ended.err;
    EXPECT_EQ(count_of(ended.err, "is bred on from"), 1U) << ended.err;
    Database database(folder / "state" / "quadrat.db");
    EXPECT_EQ(database.number("SELECT count(*) FROM memory WHERE name='collection' AND value LIKE '%\"chosen\":1.0%'"),
              1);
    EXPECT_EQ(database.number("SELECT count(*) FROM generation WHERE deeds LIKE '=Q%'"), 1);
    // The next run hangs what this one bred.
    const Ended again = play(folder, "rounds = 1\n", "wait 60s\n", "later");
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(database.number("SELECT count(*) FROM memory WHERE name='collection'"), 1);
}

// On the machine's own clock, for paper and walls know no other.
class OnPaper : public testing::Test {
  protected:
    void lp(const std::string& text) {
        std::filesystem::create_directories(folder / "bin");
        folder.write("bin/lp", "#!/bin/sh\n" + text);
        std::filesystem::permissions(folder / "bin/lp", std::filesystem::perms::owner_all);
    }
    std::vector<std::string> exhibit(const std::string& settings) {
        folder.write("site.toml", kSmall +
                                      "[visit]\nrounds = 1\nfinale_s = 600\npatience_s = 600\ndescribe_words = 0\n" +
                                      settings + "[take_home]\nurl = \"" + kAddress + "\"\n");
        folder.write(
            "visit.script",
            "wait 6s\npress A\nwait 3s\npress A\nwait 3s\npress B\nwait 3s\npress C\nwait 20s\npress C\nwait 900s\n");
        auto command = program({"run", "--config", "site.toml", "--display", "headless", "--size", "640x360", "--input",
                                "script:visit.script", "--state", "state", "--seed", "5", "--speed", "1.001"});
        command.insert(command.begin(),
                       {"env", "PATH=" + (folder / "bin").string() + ":" + std::string(std::getenv("PATH"))});
        return command;
    }
    template <typename Condition>
    bool comes(Process& process, const Condition& condition) {
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds{kIsSanitized ? 400 : 150};
        while (process.is_running() && std::chrono::steady_clock::now() < until) {
            if (condition()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds{100});
        }
        return condition();
    }
    std::string said() const { return contents_of(folder / "stderr.txt"); }

    TemporaryFolder folder;
};

TEST_F(OnPaper, APostcardComesOutWhenItIsAskedForAndNothingOfItIsKept) {
    lp("echo \"$@\" >" + (folder / "asked.txt").string() + "\nfor last; do :; done\ncp \"$last\" " +
       (folder / "printed.png").string() + ".part && mv " + (folder / "printed.png").string() + ".part " +
       (folder / "printed.png").string() + "\n");
    Process running(exhibit("[postcard]\nprinter = \"cards\"\nplace = \"Museum\"\n"), folder.path());
    ASSERT_TRUE(comes(running, [&] { return std::filesystem::exists(folder / "printed.png"); })) << said();
    ASSERT_TRUE(comes(running, [&] { return count_of(said(), "a postcard goes to the printer cards") == 1; }))
        << said();
    const std::string asked = contents_of(folder / "asked.txt");
    EXPECT_THAT(asked, HasSubstr("-d cards "));
    const std::string file = asked.substr(asked.rfind(' ') + 1, asked.size() - asked.rfind(' ') - 2);
    EXPECT_FALSE(std::filesystem::exists(file)) << file;
    const Ended read = run({"zbarimg", "--quiet", "--raw", "printed.png"}, folder);
    EXPECT_THAT(read.out, testing::StartsWith(kAddress + "Q"));
    running.kill(SIGTERM);
    EXPECT_TRUE(succeeds(running.wait()));
}

TEST_F(OnPaper, AMissingPrinterCostsNoVisitAndIsSaidOnceAndInHealth) {
    lp("echo 'lp: The printer or class does not exist.' >&2\nexit 1\n");
    Process running(exhibit("[postcard]\nprinter = \"cards\"\nwhen = \"always\"\n"), folder.path());
    const std::string trouble = "printer cards: lp: The printer or class does not exist.";
    ASSERT_TRUE(comes(running, [&] { return count_of(said(), trouble) > 0; })) << said();
    ASSERT_TRUE(comes(running, [&] {
        const auto health = folder / "state/health.json";
        return std::filesystem::exists(health) && count_of(contents_of(health), trouble) > 0;
    }));
    EXPECT_EQ(count_of(said(), trouble), 1U);
    running.kill(SIGTERM);
    EXPECT_TRUE(succeeds(running.wait()));
}

TEST(AWall, ShowsWhatTheVisitorsOfAnExhibitBred) {
    const TemporaryFolder folder;
    const std::string take_home = "rounds = 1\n[take_home]\nurl = \"" + kAddress + "\"\n";
    const Ended bred =
        play(folder, take_home, "at 2s press A\n" + round_of("A", "B", "C") + "after 4s press D\n", "pictures");
    ASSERT_EQ(bred.status, 0) << bred.err;
    const Ended code = run(program({"code", "encode", "pictures/finale-01.png"}), folder);
    Process wall(program({"run", "--gallery", "--config", "site.toml", "--display", "headless", "--size", "1280x720",
                          "--state", "state", "--speed", "1.001"}),
                 folder.path());
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds{kIsSanitized ? 400 : 150};
    std::string read;
    while (wall.is_running() && read.empty() && std::chrono::steady_clock::now() < until) {
        const TemporaryFolder elsewhere;
        const std::string state = (folder / "state" / "wall").string();
        if (run(program({"shot", "-o", "now.png", "--state", state}), elsewhere).status != 0) continue;
        const Ended seen = run({"zbarimg", "--quiet", "--raw", "now.png"}, elsewhere);
        if (seen.status == 0) read = seen.out;
    }
    EXPECT_EQ(read, kAddress + code.out) << contents_of(folder / "stderr.txt");
    wall.kill(SIGTERM);
    EXPECT_TRUE(succeeds(wall.wait()));
}

}  // namespace
