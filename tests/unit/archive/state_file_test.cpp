// SPDX-License-Identifier: Apache-2.0
#include "archive/state_file.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "archive/archive_schema.hpp"
#include "archive/word_answers.hpp"
#include "base/error.hpp"
#include "unit/archive/archive_fixture.hpp"

namespace quadrat::archive {
namespace {

using testing::HasSubstr;

class StateFileOnDisk : public ArchiveOnDisk {
  protected:
    // A file of some pages, at rest.
    void fill(int visits = 40) const {
        Archive archive = open().archive;
        for (int i = 0; i < visits; ++i) {
            const auto begun = archive.begin_visit(kNow);
            ASSERT_FALSE(archive.append(generation_of(begun.visit, 6)));
            ASSERT_FALSE(archive.post("visits", "{}"));
        }
        ASSERT_FALSE(archive.remember("gpu", "one of 2031"));
        ASSERT_FALSE(archive.remember("buttons", "A 17"));
    }
    std::string bytes_of(const std::filesystem::path& path) const {
        std::ifstream stream(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(directory_))
            all.push_back(entry.path().filename().string());
        std::ranges::sort(all);
        return all;
    }
};

TEST_F(StateFileOnDisk, ThatIsMissingOrEmptyIsSaidToBe) {
    EXPECT_EQ(examine_state_file(file()).condition, Condition::Missing);
    std::ofstream(file()).close();
    EXPECT_EQ(examine_state_file(file()).condition, Condition::Missing);
}

TEST_F(StateFileOnDisk, IsFoundWholeAndNothingIsMadeBesideIt) {
    fill();
    const std::string before = bytes_of(file());
    const StateReport report = examine_state_file(file());
    EXPECT_EQ(report.condition, Condition::Whole) << report.what;
    EXPECT_EQ(report.version, state_version());
    EXPECT_EQ(report.file_bytes, before.size());
    EXPECT_EQ(names(), std::vector<std::string>{"quadrat.db"});
    EXPECT_EQ(bytes_of(file()), before);
}

TEST_F(StateFileOnDisk, OfARunningExhibitIsFoundWholeAndItsLogCounts) {
    Archive running = open().archive;
    ASSERT_FALSE(running.append(generation_of(running.begin_visit(kNow).visit, 1)));
    const StateReport report = examine_state_file(file());
    EXPECT_EQ(report.condition, Condition::Whole) << report.what;
    EXPECT_GT(report.log_bytes, 0U);
    EXPECT_EQ(report.log_bytes, std::filesystem::file_size(file().string() + "-wal"));
}

TEST_F(StateFileOnDisk, WithADamagedPageIsFoundBeforeTheNextStartSetsItAside) {
    fill();
    const auto size = std::filesystem::file_size(file());
    std::fstream(file(), std::ios::binary | std::ios::in | std::ios::out)
        .seekp(static_cast<std::streamoff>(size / 2))
        .write(std::string(2048, '\xa5').data(), 2048);
    const std::string before = bytes_of(file());
    EXPECT_EQ(examine_state_file(file()).condition, Condition::Damaged);
    EXPECT_EQ(bytes_of(file()), before);
    EXPECT_EQ(names(), std::vector<std::string>{"quadrat.db"});
    EXPECT_EQ(open().condition, Archive::Condition::Replaced) << "as was said";
}

TEST_F(StateFileOnDisk, OfANewerProgramIsToldFromADamagedOne) {
    fill();
    Connection(file()).run("PRAGMA user_version=99");
    const StateReport report = examine_state_file(file());
    EXPECT_EQ(report.condition, Condition::Newer);
    EXPECT_THAT(report.what, HasSubstr("version is 99"));
    EXPECT_EQ(open().condition, Archive::Condition::Replaced) << "as was said";
}

TEST_F(StateFileOnDisk, OfAnOlderProgramIsLeftAsItIs) {
    fill();
    for (int version = state_version() - 1; version >= 1; --version) {
        move_state(directory_, version);
        const StateReport report = examine_state_file(file());
        EXPECT_EQ(report.condition, Condition::Older) << report.what;
        EXPECT_EQ(report.version, version);
        EXPECT_TRUE(word_answers_in(directory_).readable.empty());
        EXPECT_EQ(Connection(file()).integer("PRAGMA user_version"), version) << "reading moves nothing";
    }
}

TEST_F(StateFileOnDisk, IsCopiedBesideARunningExhibitWithWhatIsInItsLogAlone) {
    Archive running = open().archive;
    ASSERT_FALSE(running.append(generation_of(running.begin_visit(kNow).visit, 3)));
    double last = 0;
    const auto copy = directory_ / "copy.db";
    copy_state(directory_, copy, [&](double share) { last = share; });
    EXPECT_EQ(last, 1);
    EXPECT_EQ(examine_state_file(copy).condition, Condition::Whole);
    EXPECT_EQ(Connection(copy, Access::ReadAtRest).integer("SELECT max(round) FROM generation"), 3);
    EXPECT_FALSE(std::filesystem::exists(copy.string() + "-wal"));
    ASSERT_FALSE(running.append(generation_of(1, 4))) << "the exhibit was not disturbed";
}

TEST_F(StateFileOnDisk, ThatIsDamagedIsNotCopied) {
    std::ofstream(file()) << "no database at all, and longer than the head of one, which has a hundred bytes: "
                          << std::string(100, '.');
    EXPECT_THROW(copy_state(directory_, directory_ / "copy.db"), base::InputError);
}

TEST_F(StateFileOnDisk, ForgetsTheMachineAndKeepsWhatWasLearnt) {
    fill();
    forget_machine(file());
    EXPECT_EQ(examine_state_file(file()).condition, Condition::Whole);
    const Connection left(file(), Access::ReadAtRest);
    for (const char* table : {"visit", "generation", "start", "outbox"})
        EXPECT_EQ(left.integer(fmt::format("SELECT count(*) FROM {}", table)), 0) << table;
    EXPECT_EQ(left.integer("SELECT count(*) FROM memory WHERE name='gpu'"), 1);
    EXPECT_EQ(left.integer("SELECT count(*) FROM memory WHERE name='buttons'"), 0);
    EXPECT_EQ(Archive::open(directory_, kNow).archive.begin_visit(kNow).visit, 1);
}

}  // namespace
}  // namespace quadrat::archive
