// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

#include "journeys/quadrat_program.hpp"
#include "journeys/state_database.hpp"

namespace {

using namespace quadrat::tests;

// One answer to each question of a round, pressed by a hand that is in no hurry.
std::string round_of(const std::string& a, const std::string& b, const std::string& c) {
    return "after 1500ms press " + a + "\nafter 1500ms press " + b + "\nafter 1500ms press " + c + "\n";
}

// 30 presses that count or not: bounces, a chord, a silence long enough for "Still there?", a Back.
std::string lively_visit() {
    return "# a whole visit\n"
           "at 2s press A\n" +                               // 1: wakes the exhibit
           round_of("B", "C", "D") +                         // 2-4
           "after 1500ms bounce A 12 edges over 8ms\n"       // 5
           "after 1500ms press B\n"                          // 6
           "after 1500ms press Back\n"                       // 7: takes the answer back
           "after 1500ms press C\n"                          // 8
           "after 1500ms press D\n" +                        // 9
           round_of("A", "A", "A") +                         // 10-12
           "wait 30s\n"                                      // silence: "Still there?"
           "press D\n"                                       // 13: still here, no answer
           "after 1500ms chord A+B\n" +                      // 14, 15: the first of the two is the answer
           "after 1500ms press C\nafter 1500ms press C\n" +  // 16, 17
           round_of("D", "D", "D") +                         // 18-20
           round_of("B", "A", "B") +                         // 21-23
           "after 9s press D\n"                              // 24: in the finale: done, back to the start
           "after 3s press B\n" +                            // 25: another visitor
           round_of("A", "B", "C") +                         // 26-28
           "after 1500ms press D\nafter 1500ms press D\n";   // 29, 30; then they walk away
}

Ended play(const TemporaryFolder& folder, const std::vector<std::string>& more) {
    folder.write("visit.script", lively_visit());
    const std::string six_rounds = "[visit]\nrounds_early = 0\nrounds_more = 0\n";
    folder.write("six.toml", six_rounds);
    folder.write("small.toml", "[picture]\nland_samples = 129\n" + six_rounds);
    std::vector<std::string> command{
        "run",     "--display", "headless",  "--size",   "320x180", "--input", "script:visit.script",
        "--state", "state",     "--capture", "pictures", "--seed",  "7"};
    command.insert(command.end(), more.begin(), more.end());
    return run(program(command), folder);
}

TEST(Visit, ThirtyPressesPlayAWholeVisitAndLeaveStatePicturesAndLogAsTheyShould) {
    const TemporaryFolder folder;
    const Ended ended = play(folder, {"--config", "six.toml"});
    ASSERT_EQ(ended.status, 0) << ended.err;

    // The log: every press was heard once, bounces and all.
    EXPECT_EQ(count_of(ended.err, " press "), 30U) << ended.err;
    EXPECT_EQ(count_of(ended.err, "a visit begins"), 2U);
    EXPECT_EQ(count_of(ended.err, "the visit ends with its finale, after 6 rounds"), 1U) << ended.err;
    EXPECT_EQ(count_of(ended.err, "the visit ends unanswered"), 1U) << ended.err;
    EXPECT_EQ(count_of(ended.err, " error "), 0U);

    // The pictures: six generations of the first visit, its finale, the first two of the second, and the sheet.
    for (const char* name :
         {"generation-01.png", "generation-06.png", "finale-01.png", "generation-08.png", "contact-sheet.png"})
        EXPECT_GT(std::filesystem::file_size(folder / "pictures" / name), 5000U) << name;
    EXPECT_FALSE(std::filesystem::exists(folder / "pictures" / "generation-09.png"));
    EXPECT_NE(ended.out.find("contact-sheet.png"), std::string::npos);

    // The state on disk: both visits and their generations, the last one whole.
    Database database(folder / "state" / "quadrat.db");
    EXPECT_EQ(database.number("PRAGMA integrity_check"), 0);  // the text "ok" reads as 0, a missing table as -1
    EXPECT_EQ(database.number("SELECT count(*) FROM visit"), 2);
    EXPECT_GE(database.number("SELECT count(*) FROM generation"), 8);
}

TEST(Visit, TheSameScriptAndSeedLeaveTheSamePictures) {
    const TemporaryFolder one;
    const TemporaryFolder other;
    ASSERT_EQ(play(one, {"--rounds", "1"}).status, 0);
    ASSERT_EQ(play(other, {"--rounds", "1"}).status, 0);
    const std::string first = contents_of(one / "pictures" / "generation-01.png");
    EXPECT_GT(first.size(), 5000U);
    EXPECT_EQ(first, contents_of(other / "pictures" / "generation-01.png"));
    EXPECT_EQ(contents_of(one / "pictures" / "finale-01.png"), contents_of(other / "pictures" / "finale-01.png"));
}

TEST(Visit, WithoutScreenAndButtonsAVisitorIsPlayedAndPicturesAreLeft) {
    const TemporaryFolder folder;
    folder.write("small.toml", "[picture]\nland_samples = 129\n");
    const Ended ended = run(program({"run", "--config", "small.toml", "--display", "headless", "--size", "320x180",
                                     "--rounds", "2", "--state", "state"}),
                            folder);
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(count_of(ended.err, "a visitor of 2 rounds is played"), 1U) << ended.err;
    for (const char* name : {"generation-01.png", "generation-02.png", "finale-01.png", "contact-sheet.png"})
        EXPECT_TRUE(std::filesystem::exists(folder / "quadrat-pictures" / name)) << name;
    EXPECT_NE(ended.out.find("quadrat-pictures"), std::string::npos);
}

TEST(Visit, BySlidersChoosesTurnsTakesBackAndEndsInTheFinale) {
    const TemporaryFolder folder;
    folder.write("sliders.toml",
                 "[picture]\nland_samples = 129\n[visit]\nrounds = 1\n[breeding]\nbreeder = \"sliders\"\n");
    folder.write("visit.script",
                 "at 2s press A\n"            // wakes the exhibit
                 "after 1500ms press B\n"     // the next slider
                 "after 1500ms press D\n"     // turned up
                 "after 1500ms press Back\n"  // taken back
                 "after 1500ms press C\nafter 1500ms press C\nafter 1500ms press D\n");
    const Ended ended =
        run(program({"run", "--config", "sliders.toml", "--display", "headless", "--size", "320x180", "--input",
                     "script:visit.script", "--state", "state", "--capture", "pictures", "--seed", "3"}),
            folder);
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(count_of(ended.err, "the visit ends with its finale, after 1 rounds"), 1U) << ended.err;
    const std::string first = contents_of(folder / "pictures" / "generation-01.png");
    EXPECT_GT(first.size(), 5000U);
    EXPECT_NE(contents_of(folder / "pictures" / "generation-02.png"), first) << "what was turned is seen";
    EXPECT_GT(std::filesystem::file_size(folder / "pictures" / "finale-01.png"), 5000U);
}

// Every visit here; nobody is told, and the report is.
TEST(AControlArm, IsBredByChanceAloneAndComparedInTheReport) {
    const TemporaryFolder folder;
    folder.write(
        "site.toml",
        "[picture]\nland_samples = 65\n[visit]\nrounds = 2\ndescribe_words = 0\n[breeding]\ncontrol_every = 1\n");
    std::string script = "at 2s press A\n";
    for (int answer = 0; answer < 6; ++answer) script += "after 2s press B\n";
    folder.write("visit.script", script + "wait 40s\n");
    const Ended ended = run(program({"run", "--config", "site.toml", "--display", "headless", "--size", "320x180",
                                     "--input", "script:visit.script", "--state", "state", "--seed", "7"}),
                            folder);
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(count_of(ended.err, "the visit ends with its finale, after 2 rounds"), 1U) << ended.err;
    const Ended report = run(program({"report", "--state", "state", "-o", "report.json"}), folder);
    ASSERT_EQ(report.status, 0) << report.err;
    const auto control = nlohmann::json::parse(contents_of(folder / "report.json"))["control"];
    EXPECT_EQ(control["chance"]["visits"], 1);
    EXPECT_EQ(control["chance"]["rounds"], 2);
    EXPECT_EQ(control["bred"]["visits"], 0);
}

}  // namespace
