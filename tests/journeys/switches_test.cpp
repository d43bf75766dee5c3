// SPDX-License-Identifier: Apache-2.0
// Whole visits by hands that have one button, or two.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "journeys/quadrat_program.hpp"
#include "journeys/state_database.hpp"

namespace {

using namespace quadrat::tests;
using testing::ElementsAre;

Ended play(const TemporaryFolder& folder, const std::string& settings, const std::string& script) {
    folder.write(
        "site.toml",
        "[picture]\nland_samples = 65\n[visit]\nrounds = 1\ndescribe_every = 1\ndescribe_words = 1\nfamily = false\n" +
            settings);
    folder.write("visit.script", script);
    return run(program({"run", "--config", "site.toml", "--display", "headless", "--size", "320x180", "--input",
                        "script:visit.script", "--state", "state", "--capture", "pictures", "--seed", "7"}),
               folder);
}

// What the visit heard, in order.
std::vector<std::string> heard(const std::string& log) {
    static const std::regex press(R"( press (\w+) at )");
    std::vector<std::string> buttons;
    for (std::sregex_iterator it(log.begin(), log.end(), press), end; it != end; ++it) buttons.push_back((*it)[1]);
    return buttons;
}

void expect_a_whole_visit(const TemporaryFolder& folder, const Ended& ended) {
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(count_of(ended.err, "the visit ends with its finale, after 1 rounds"), 1U) << ended.err;
    EXPECT_EQ(count_of(ended.err, "it was called"), 1U) << ended.err;
    EXPECT_GT(std::filesystem::file_size(folder / "pictures" / "finale-01.png"), 5000U);
    Database database(folder / "state" / "quadrat.db");
    EXPECT_EQ(database.number("SELECT count(*) FROM visit"), 1);
    EXPECT_EQ(database.number("SELECT count(*) FROM word_answer"), 1);
}

// The mark stands on A for 1.5 s from when the button is let go, then for a second on each.
TEST(OneButton, HeldAtTheBeginningPlaysTheWholeVisitWithBackAndDescribe) {
    const TemporaryFolder folder;
    const Ended ended = play(folder, "[play]\npace_s = 1\n",
                             "at 2s hold D for 5s\n"  // asks for one button
                             "at 10s press D\n"       // the trees of C
                             "at 12s press D\n"       // the land of B
                             "at 17s press D\n"       // Back: not that land
                             "at 18s press D\n"       // the land of A
                             "at 20s press D\n"       // the sky of B
                             "at 25s press D\n"       // the finale has been looked at
                             "at 28s press D\n");     // the third of four answers
    expect_a_whole_visit(folder, ended);
    EXPECT_THAT(heard(ended.err), ElementsAre("D", "C", "B", "Back", "A", "B", "D", "C")) << ended.err;
    EXPECT_EQ(count_of(ended.err, "played with one button"), 1U);
    EXPECT_EQ(count_of(ended.err, "played with four buttons"), 1U) << "for the next visitor";
}

TEST(OneButton, ThatOnlyStepsPlaysTheWholeVisitByResting) {
    const TemporaryFolder folder;
    const std::string go_on = "after 600ms press B\n";
    const Ended ended = play(folder, "[play]\nbuttons = \"one\"\ndwell_s = 2\n",
                             "at 2s press B\n" + go_on + go_on + go_on + "wait 3s\n" + go_on + "wait 3s\n" + go_on +
                                 go_on + "wait 8s\nafter 2s press B\n" + go_on + go_on + "wait 3s\n");
    expect_a_whole_visit(folder, ended);
    EXPECT_THAT(heard(ended.err), ElementsAre("B", "C", "A", "B", "B", "B")) << ended.err;
}

TEST(TwoButtons, OfTheSitePlayTheWholeVisitInTheirOwnTime) {
    const TemporaryFolder folder;
    const std::string go_on = "after 600ms press A\n", take = "after 900ms press C\n";
    const Ended ended = play(folder, "[play]\nbuttons = \"two\"\n",
                             "at 2s press A\n" + go_on + take + go_on + go_on + go_on + take + "wait 40s\n" + go_on +
                                 go_on + go_on + go_on + take + take + take + "after 5s press C\n" + go_on + take);
    expect_a_whole_visit(folder, ended);
    EXPECT_THAT(heard(ended.err), ElementsAre("A", "B", "D", "Back", "A", "A", "C", "B")) << ended.err;
}

TEST(FourButtons, AreAsTheyWereWhereNobodyMayHold) {
    const TemporaryFolder folder;
    const Ended ended =
        play(folder, "[play]\nhold_s = 0\n",
             "at 2s hold D for 8s\nafter 1s press A\nafter 1s press B\nafter 1s press C\nafter 5s press A\n"
             "after 1s press D\n");
    expect_a_whole_visit(folder, ended);
    EXPECT_THAT(heard(ended.err), ElementsAre("D", "A", "B", "C", "A", "D"));
    EXPECT_EQ(count_of(ended.err, "played with"), 0U);
}

double rounds_a_minute(const std::string& table, const std::string& name) {
    const std::size_t at = table.find(name);
    if (at == std::string::npos) return 0;
    std::istringstream row(table.substr(at + name.size(), table.find('\n', at) - at - name.size()));
    double minutes = 0, rate = 0;
    row >> minutes >> rate;
    return rate;
}

TEST(Simulate, TellsHowManyRoundsAMinuteArePlayedWithSwitches) {
    const TemporaryFolder folder;
    const Ended told = run(program({"simulate", "--switches", "--visitors", "10", "--rounds", "3"}), folder);
    ASSERT_TRUE(succeeds(told));
    const double four = rounds_a_minute(told.out, "four buttons"), quick = rounds_a_minute(told.out, "pace_s = 1.0"),
                 slow = rounds_a_minute(told.out, "pace_s = 3.0");
    EXPECT_GT(four, quick) << told.out;
    EXPECT_GT(quick, slow) << told.out;
    EXPECT_GT(slow, 0.5) << told.out;
}

}  // namespace
