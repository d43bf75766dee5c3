// SPDX-License-Identifier: Apache-2.0
// Which settings a service begins with, and which it keeps for worse days.
#include "site/settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "staff/settings_in_use.hpp"
#include "support/process.hpp"

namespace quadrat::site {
namespace {

using namespace std::chrono_literals;
using staff::SettingsInUse;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kRight = "[visit]\nrounds = 3\n";
constexpr const char* kWrong = "[visit]\nrounds = 300\n";

class AService : public testing::Test {
  protected:
    Settings begun() const { return settings_for_service(file_, folder_.path()); }
    Settings begun_with(const std::string& toml) const {
        folder_.write("quadrat.toml", toml);
        return begun();
    }
    tests::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "quadrat.toml";
};

TEST_F(AService, BeginsWithItsFileWhereThatIsRight) {
    const Settings settings = begun_with(kRight);
    EXPECT_EQ(settings.from, SettingsFrom::File);
    EXPECT_EQ(settings.configuration.visit.rounds, 3);
    EXPECT_EQ(settings.toml, kRight);
    EXPECT_THAT(settings.mistakes, IsEmpty());
}

TEST_F(AService, BeginsWithTheLastThatWorkedWhateverHasBecomeOfItsFile) {
    keep_last_good(folder_.path(), kRight);
    for (const char* toml : {kWrong, "", "[visit\nrounds = 3\n", "[vist]\n", "\xff\xfe"}) {
        const Settings settings = begun_with(toml);
        EXPECT_EQ(settings.from, SettingsFrom::LastGood) << toml;
        EXPECT_EQ(settings.configuration.visit.rounds, 3) << toml;
        ASSERT_FALSE(settings.mistakes.empty()) << toml;
        EXPECT_EQ(settings.mistakes.front().file, file_.string());
    }
    std::filesystem::remove(file_);
    EXPECT_EQ(begun().from, SettingsFrom::LastGood);
    EXPECT_THAT(begun().mistakes.front().what, HasSubstr("cannot read"));
    EXPECT_EQ(begun().held, std::nullopt);
}

TEST_F(AService, BeginsWithTheDefaultsWhereNoneHasWorkedYet) {
    const Settings settings = begun_with(kWrong);
    EXPECT_EQ(settings.from, SettingsFrom::Defaults);
    EXPECT_EQ(settings.configuration.visit.rounds, Configuration{}.visit.rounds);
    EXPECT_EQ(settings.toml, "");
    ASSERT_EQ(settings.mistakes.size(), 1U);
    EXPECT_EQ(settings.mistakes.front(),
              (Mistake{file_.string(), 2, "visit.rounds is 300", "it must lie between 1 and 50"}));
}

TEST_F(AService, KnowsAFileThatIsCutInTheMiddleOfALineByTheLastThatWorked) {
    keep_last_good(folder_.path(), "[visit]\nrounds = 12\npatience_s = 30\n");
    const Settings cut = begun_with("[visit]\nrounds = 1");
    EXPECT_EQ(cut.from, SettingsFrom::LastGood);
    EXPECT_EQ(cut.configuration.visit.rounds, 12);
    EXPECT_EQ(cut.mistakes.front().line, 2);
    EXPECT_EQ(begun_with("[visit]\nrounds = 12").from, SettingsFrom::File) << "the last line was deleted";
    EXPECT_EQ(begun_with("[visit]\nrounds = 1\n").from, SettingsFrom::File) << "that is another number";
    EXPECT_EQ(begun_with("[visit]\nrounds = 13").from, SettingsFrom::File);
}

TEST_F(AService, TakesOfTheLastThatWorkedWhatIsStillRight) {
    keep_last_good(folder_.path(), "[visit]\nrounds = 4\npatience_s = 9999\n");
    const Settings settings = begun_with(kWrong);
    EXPECT_EQ(settings.from, SettingsFrom::LastGood);
    EXPECT_EQ(settings.configuration.visit.rounds, 4);
    EXPECT_EQ(settings.configuration.visit.patience_s, Configuration{}.visit.patience_s);
}

TEST_F(AService, WhoseSettingsCannotBeOpenedGoesDownStepByStep) {
    keep_last_good(folder_.path(), kRight);
    const Mistake why{file_.string(), 0, "there is no desktop", ""};
    Settings settings = begun_with("[screen]\ndisplay = \"window\"\n");
    auto next = next_settings(settings, folder_.path(), why);
    ASSERT_TRUE(next.has_value());
    EXPECT_EQ(next->from, SettingsFrom::LastGood);
    EXPECT_THAT(next->mistakes, ElementsAre(why));
    next = next_settings(*next, folder_.path(), why);
    ASSERT_TRUE(next.has_value());
    EXPECT_EQ(next->from, SettingsFrom::Defaults);
    EXPECT_EQ(next_settings(*next, folder_.path(), why), std::nullopt) << "nothing comes after the defaults";
}

TEST_F(AService, DoesNotTryTheSameSettingsTwice) {
    keep_last_good(folder_.path(), kRight);
    const auto next = next_settings(begun_with(kRight), folder_.path(), {file_.string(), 0, "no desktop", ""});
    ASSERT_TRUE(next.has_value());
    EXPECT_EQ(next->from, SettingsFrom::Defaults);
}

TEST_F(AService, ThatKeepsFailingWithOtherSettingsGoesBackToThoseThatWorked) {
    keep_last_good(folder_.path(), kRight);
    const std::string changed = "[visit]\nrounds = 5\n";
    const Settings safe = safe_settings(begun_with(changed), folder_.path(), 3);
    EXPECT_EQ(safe.from, SettingsFrom::LastGood);
    EXPECT_EQ(safe.configuration.visit.rounds, 3);
    EXPECT_THAT(safe.mistakes.front().what, HasSubstr("failed 3 times"));
    EXPECT_EQ(safe_settings(begun_with(kRight), folder_.path(), 3).from, SettingsFrom::File)
        << "the settings are not to blame";
}

TEST_F(AService, ThatPeopleStartRefusesWithAllMistakes) {
    keep_last_good(folder_.path(), kRight);
    folder_.write("quadrat.toml", "[visit]\nrounds = 300\npatience_s = true\n");
    try {
        settings_for_people(file_, folder_.path());
        FAIL() << "it was taken";
    } catch (const SettingsError& error) {
        EXPECT_EQ(error.mistakes().size(), 2U);
        EXPECT_THAT(error.what(), HasSubstr("quadrat.toml:3: visit.patience_s is not a number"));
    }
    EXPECT_EQ(settings_for_people("", "").configuration.visit.rounds, Configuration{}.visit.rounds);
}

TEST(LastGood, IsWrittenOnceAndOnlyWhenItChanges) {
    const tests::TemporaryFolder folder;
    const auto file = last_good_file(folder.path() / "state");
    keep_last_good(folder.path() / "state", kRight);
    EXPECT_EQ(tests::contents_of(file), kRight);
    const auto before = std::filesystem::file_time_type::clock::now() - 1h;
    std::filesystem::last_write_time(file, before);
    keep_last_good(folder.path() / "state", kRight);
    EXPECT_EQ(std::filesystem::last_write_time(file), before);
}

Settings from_file(const std::string& toml) {
    Settings settings;
    settings.file = "quadrat.toml";
    settings.toml = toml;
    return settings;
}

TEST(SettingsInUse, AreProvedByAMinuteOnTheScreen) {
    staff::SettingsInUse settings(from_file(kRight));
    EXPECT_EQ(settings.take_proved(100s, false), std::nullopt) << "nobody saw anything";
    EXPECT_EQ(settings.take_proved(101s, true), std::nullopt);
    EXPECT_EQ(settings.take_proved(160s, true), std::nullopt);
    EXPECT_EQ(settings.take_proved(161s, true), kRight);
    EXPECT_EQ(settings.take_proved(300s, true), std::nullopt) << "once";
}

TEST(SettingsInUse, BeginTheirMinuteAnewWhenTheScreenGoesOrTheyChange) {
    staff::SettingsInUse settings(from_file(kRight));
    settings.take_proved(0s, true);
    settings.take_proved(50s, false);
    EXPECT_EQ(settings.take_proved(70s, true), std::nullopt);
    settings.follow("# all\n", "");
    EXPECT_EQ(settings.take_proved(140s, true), std::nullopt);
    EXPECT_EQ(settings.take_proved(200s, true), "# all\n");
}

TEST(SettingsInUse, ThatWaitForARestartAreNotProvedByWhatIsSeenBefore) {
    staff::SettingsInUse settings(from_file(kRight));
    settings.follow("[screen]\nmode = \"800x600\"\n", "screen");
    settings.take_proved(0s, true);
    EXPECT_EQ(settings.take_proved(100s, true), std::nullopt);
    EXPECT_EQ(settings.news().after_restart, "screen");
}

TEST(SettingsInUse, WantASignOnlyWhereTheyAreNotTheSites) {
    Settings wrong = from_file("");
    EXPECT_FALSE(staff::SettingsInUse(wrong).needs_sign());
    wrong.mistakes = {{"quadrat.toml", 2, "visit.rounds is 300", "it must lie between 1 and 50"}};
    wrong.from = SettingsFrom::LastGood;
    EXPECT_FALSE(staff::SettingsInUse(wrong).needs_sign());
    wrong.from = SettingsFrom::Defaults;
    staff::SettingsInUse settings(wrong);
    EXPECT_TRUE(settings.needs_sign());
    settings.take_proved(0s, true);
    EXPECT_EQ(settings.take_proved(100s, true), std::nullopt) << "defaults are nobody's settings";
    settings.follow(kRight, "");
    EXPECT_FALSE(settings.needs_sign());
    EXPECT_THAT(settings.news().mistakes, IsEmpty());
}

TEST(SettingsInUse, TellStaffTheFileTheLineAndTheRemedy) {
    staff::SettingsNews news;
    EXPECT_THAT(staff::lines_for_staff(news), IsEmpty());
    news.from = SettingsFrom::LastGood;
    for (int line = 1; line <= 5; ++line) news.mistakes.push_back({"/etc/q.toml", line, "visit.x is 3", "write 2"});
    EXPECT_THAT(staff::lines_for_staff(news),
                ElementsAre("SETTINGS: the last settings that worked are used", "/etc/q.toml, line 1: visit.x is 3",
                            "  → write 2", "/etc/q.toml, line 2: visit.x is 3", "  → write 2",
                            "/etc/q.toml, line 3: visit.x is 3", "  → write 2", HasSubstr("and 2 more")));
}

}  // namespace
}  // namespace quadrat::site
