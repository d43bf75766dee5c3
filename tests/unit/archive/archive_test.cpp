// SPDX-License-Identifier: Apache-2.0
#include "archive/archive.hpp"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/file.hpp"
#include "unit/archive/archive_fixture.hpp"

namespace quadrat::archive {
namespace {

namespace fs = std::filesystem;
using Condition = Archive::Condition;
using genome::Aspect;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> names_in(const fs::path& directory) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

TEST_F(ArchiveOnDisk, GivesBackTheLastGenerationAfterItIsOpenedAgain) {
    {
        Archive::Opened opened = open();
        EXPECT_EQ(opened.condition, Condition::Fresh);
        EXPECT_EQ(opened.archive.latest(), std::nullopt);
        const auto [visit, trouble] = opened.archive.begin_visit(kNow);
        EXPECT_EQ(visit, 1);
        EXPECT_EQ(trouble, std::nullopt);
        for (int round = 1; round <= 5; ++round)
            ASSERT_EQ(opened.archive.append(generation_of(visit, round)), std::nullopt);
        EXPECT_EQ(opened.archive.latest(), generation_of(visit, 5));
    }
    const Archive::Opened again = open();
    EXPECT_EQ(again.condition, Condition::Continued);
    EXPECT_EQ(again.archive.latest(), generation_of(1, 5));
    EXPECT_TRUE(again.archive.is_open(1));
}

TEST_F(ArchiveOnDisk, CreatesItsDirectory) {
    directory_ /= "not/yet/there";
    EXPECT_EQ(open().condition, Condition::Fresh);
    EXPECT_TRUE(fs::exists(file()));
}

TEST_F(ArchiveOnDisk, KeepsTheAnswersOfTheGenerationOnScreen) {
    Archive archive = std::move(open().archive);
    ASSERT_EQ(archive.append(generation_of(1, 3)), std::nullopt);
    genome::Pick answers;
    answers[Aspect::Trees] = 2;
    answers[Aspect::Land] = 1;
    ASSERT_EQ(archive.keep_answers(1, 3, answers, kNow), std::nullopt);
    EXPECT_EQ(archive.latest()->answers, answers);
    answers[Aspect::Land].reset();
    ASSERT_EQ(archive.keep_answers(1, 3, answers, kNow), std::nullopt);
    EXPECT_EQ(archive.latest()->answers, answers) << "taken back";
    answers[Aspect::Sky] = 0;
    ASSERT_EQ(archive.keep_answers(1, 2, answers, kNow), std::nullopt);
    EXPECT_EQ(archive.latest()->answers[Aspect::Sky], std::nullopt) << "of another round";
}

TEST_F(ArchiveOnDisk, LogsEachAnswerWithTheTimeAtWhichItWasGiven) {
    Archive archive = std::move(open().archive);
    genome::Pick answers;
    answers[Aspect::Trees] = 2;
    ASSERT_EQ(archive.append(generation_of(1, 1)), std::nullopt);
    ASSERT_EQ(archive.keep_answers(1, 1, answers, kNow), std::nullopt);
    answers[Aspect::Land] = 1;
    ASSERT_EQ(archive.keep_answers(1, 1, answers, kNow + std::chrono::seconds(5)), std::nullopt);
    const Connection reader(file());
    const std::int64_t start = kNow.time_since_epoch().count();
    EXPECT_EQ(reader.integer("SELECT trees_ms FROM generation WHERE trees=2"), start);
    EXPECT_EQ(reader.integer("SELECT land_ms FROM generation WHERE land=1"), start + 5000);
    EXPECT_EQ(reader.integer("SELECT count(*) FROM generation WHERE sky IS NOT NULL OR sky_ms IS NOT NULL"), 0);
}

TEST_F(ArchiveOnDisk, CountsVisitsOnAndKnowsWhichHaveEnded) {
    {
        Archive archive = std::move(open().archive);
        for (std::int64_t visit = 1; visit <= 3; ++visit) EXPECT_EQ(archive.begin_visit(kNow).visit, visit);
        ASSERT_EQ(archive.end_visit(2, exhibit::Ending::Finished, 6, kNow), std::nullopt);
    }
    Archive archive = std::move(open().archive);
    EXPECT_TRUE(archive.is_open(1));
    EXPECT_FALSE(archive.is_open(2));
    EXPECT_FALSE(archive.is_open(99));
    EXPECT_EQ(archive.begin_visit(kNow).visit, 4);
}

TEST_F(ArchiveOnDisk, ForgetsWhatIsOlderThanItsRetentionAndStaysSmall) {
    Archive archive = std::move(open({.visits = 10}).archive);
    std::uintmax_t after_100 = 0;
    for (int i = 1; i <= 200; ++i) {
        ASSERT_EQ(archive.begin_visit(kNow).trouble, std::nullopt);
        ASSERT_EQ(archive.append(generation_of(i, 1)), std::nullopt);
        genome::Pick answers;
        answers[Aspect::Trees] = 0;
        ASSERT_EQ(archive.keep_answers(i, 1, answers, kNow), std::nullopt);
        if (i == 100) after_100 = fs::file_size(file()) + fs::file_size(file().string() + "-wal");
    }
    const Connection reader(file());
    // A few visits go at a time.
    EXPECT_LE(reader.integer("SELECT count(*) FROM visit"), 26);
    EXPECT_GE(reader.integer("SELECT count(*) FROM visit"), 10);
    EXPECT_LE(reader.integer("SELECT count(*) FROM generation"), 26);
    EXPECT_EQ(archive.latest(), [] {
        Generation last = generation_of(200, 1);
        last.answers[Aspect::Trees] = 0;
        return last;
    }());
    // The log is emptied into the file now and then; 8 MB are far more than it ever holds.
    EXPECT_LT(fs::file_size(file()) + fs::file_size(file().string() + "-wal"), after_100 + (8U << 20U));
    EXPECT_LT(fs::file_size(file()), 64U << 10U) << "a visit takes about 1 kB";
}

TEST_F(ArchiveOnDisk, IsWrittenThroughToTheDiskInWalMode) {
    const Archive::Opened opened = open();
    const Connection reader(file());
    EXPECT_EQ(reader.prepare("PRAGMA journal_mode").step(), true);
    Statement mode = reader.prepare("PRAGMA journal_mode");
    ASSERT_TRUE(mode.step());
    EXPECT_EQ(mode.text(0), "wal");
    EXPECT_EQ(reader.integer("PRAGMA auto_vacuum"), 2);
    EXPECT_EQ(reader.integer("PRAGMA user_version"), 4);
    EXPECT_EQ(reader.integer("PRAGMA page_size"), 512);
}

TEST_F(ArchiveOnDisk, TellsWhatWasKeptBeforeItWritesAnything) {
    {
        Archive archive = std::move(open().archive);
        const auto begun = archive.begin_visit(kNow);
        ASSERT_EQ(archive.append(generation_of(begun.visit, 4)), std::nullopt);
        ASSERT_EQ(archive.remember("buttons", "fine"), std::nullopt);
    }
    std::vector<Kept> told;
    std::int64_t starts = -1;
    const auto opened = Archive::open(directory_, kNow, {}, [&](const Kept& kept) {
        told.push_back(kept);
        starts = Connection(file()).integer("SELECT count(*) FROM start");
    });
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told.front().interrupted, generation_of(1, 4));
    EXPECT_EQ(told.front().buttons, "fine");
    EXPECT_EQ(starts, 1) << "this start was not written yet";
}

TEST_F(ArchiveOnDisk, WritesTogetherWhatIsDoneTogether) {
    Archive archive = std::move(open().archive);
    EXPECT_EQ(archive.together(Durability::Written,
                               [&] {
                                   EXPECT_EQ(archive.begin_visit(kNow).trouble, std::nullopt);
                                   Connection other(file());
                                   EXPECT_EQ(other.integer("SELECT count(*) FROM visit"), 0) << "not yet";
                                   EXPECT_EQ(archive.append(generation_of(1, 1)), std::nullopt);
                               }),
              std::nullopt);
    EXPECT_EQ(Connection(file()).integer("SELECT count(*) FROM visit"), 1);
    EXPECT_EQ(archive.latest(), generation_of(1, 1));
}

// What a visit of six rounds writes, as the exhibit's keeper has it written: at ten hours of them, one after the other,
// 350 are played a day, and 5 MB is what a day may cost a memory card.
TEST_F(ArchiveOnDisk, WritesLessThanTenKilobytesAVisit) {
    constexpr int kVisits = 20;
    Archive archive = std::move(open().archive);
    const auto log_size = [&] { return fs::file_size(file().string() + "-wal"); };
    const std::uintmax_t before = log_size();
    for (int visit = 1; visit <= kVisits; ++visit) {
        for (int round = 1; round <= 6; ++round) {
            const Trouble trouble = archive.together(Durability::Flushed, [&] {
                if (round == 1) {
                    EXPECT_EQ(archive.begin_visit(kNow).trouble, std::nullopt);
                }
                genome::Pick answers;
                for (const Aspect aspect : genome::kAspects) {
                    if (round == 1) continue;
                    answers[aspect] = 2;
                    EXPECT_EQ(archive.keep_answers(visit, round - 1, answers, kNow), std::nullopt);
                }
                EXPECT_EQ(archive.append(generation_of(visit, round)), std::nullopt);
            });
            ASSERT_EQ(trouble, std::nullopt);
        }
        ASSERT_EQ(archive.end_visit(visit, exhibit::Ending::Finished, 6, kNow), std::nullopt);
    }
    const std::uintmax_t each = (log_size() - before) / kVisits;
    RecordProperty("bytes_a_visit", static_cast<int>(each));
    EXPECT_LT(each, 10'000U);
}

// ---- damage

void fill(const fs::path& directory) {
    Archive archive = std::move(Archive::open(directory, kNow).archive);
    for (int round = 1; round <= 30; ++round) ASSERT_EQ(archive.append(generation_of(1, round)), std::nullopt);
}

class DamagedArchive : public ArchiveOnDisk {
  protected:
    void expect_replaced(std::string_view because) {
        const std::string damaged = base::read_file(file());
        Archive::Opened opened = open();
        EXPECT_EQ(opened.condition, Condition::Replaced) << opened.message;
        EXPECT_THAT(opened.message, HasSubstr("quadrat.db: damaged"));
        EXPECT_THAT(opened.message, HasSubstr(std::string(because)));
        EXPECT_THAT(opened.message, HasSubstr("set aside as quadrat.db.damaged-20310203-040506"));
        EXPECT_THAT(opened.message, Not(HasSubstr("\n")));
        EXPECT_EQ(base::read_file(file().string() + ".damaged-20310203-040506"), damaged) << "nothing is overwritten";
        EXPECT_EQ(opened.archive.latest(), std::nullopt);
        EXPECT_EQ(opened.archive.append(generation_of(1, 1)), std::nullopt);
        EXPECT_EQ(opened.archive.latest(), generation_of(1, 1));
    }
    void change(const char* sql) {
        fill(directory_);
        Connection(file()).run(sql);
    }
};

TEST_F(DamagedArchive, IsSetAsideWhenItIsNotSqlite) {
    base::write_file(file(), std::string(5000, 'x'));
    expect_replaced("not a database");
}

TEST_F(DamagedArchive, IsSetAsideWhenItIsCutOff) {
    fill(directory_);
    fs::resize_file(file(), fs::file_size(file()) / 2);
    expect_replaced("malformed");
}

TEST_F(DamagedArchive, IsSetAsideWhenItsMiddleIsOverwritten) {
    fill(directory_);
    std::string bytes = base::read_file(file());
    for (std::size_t i = 2048; i + 512 <= bytes.size(); i += 512) bytes.replace(i, 300, 300, '\xa5');
    base::write_file(file(), bytes);
    expect_replaced("");
}

TEST_F(DamagedArchive, IsSetAsideWhenItsHeadSaysThatALaterSqliteWroteIt) {
    fill(directory_);
    std::string bytes = base::read_file(file());
    constexpr std::size_t kWriteVersion = 18;
    bytes.at(kWriteVersion) = 9;
    base::write_file(file(), bytes);
    expect_replaced("readonly");
}

TEST_F(DamagedArchive, IsSetAsideWhenItsSchemaIsOfALaterVersion) {
    change("PRAGMA user_version=5");
    expect_replaced("its schema version is 5; this program keeps versions 1 to 4");
}

TEST_F(DamagedArchive, IsSetAsideWhenItIsAnotherProgramsDatabase) {
    Connection(file()).run("CREATE TABLE song(id INTEGER)");
    expect_replaced("it is not a state file of Quadrat");
}

TEST_F(DamagedArchive, IsSetAsideWhenATableIsMissingOrAdded) {
    change("DROP TABLE outbox");
    expect_replaced("its tables are not those of its version");
}

TEST_F(DamagedArchive, IsSetAsideWhenItHoldsATrigger) {
    change("CREATE TRIGGER loop AFTER INSERT ON start BEGIN INSERT INTO start(at_ms) VALUES(1); END");
    expect_replaced("its tables are not those of its version");
}

TEST_F(DamagedArchive, IsSetAsideWhenItsLastRowCannotBeRead) {
    change("UPDATE generation SET deeds='ABC what' WHERE id=(SELECT max(id) FROM generation)");
    expect_replaced("its last generation cannot be read");
}

TEST_F(DamagedArchive, IsSetAsideUnderAnotherNameWhenThatOneIsTaken) {
    base::write_file(file(), std::string(5000, 'x'));
    EXPECT_EQ(open().condition, Condition::Replaced);
    base::write_file(file(), std::string(5000, 'y'));
    fs::remove(file().string() + "-wal");
    fs::remove(file().string() + "-shm");
    EXPECT_EQ(open().condition, Condition::Replaced);
    EXPECT_EQ(base::read_file(file().string() + ".damaged-20310203-040506"), std::string(5000, 'x'));
    EXPECT_EQ(base::read_file(file().string() + ".damaged-20310203-040506-2"), std::string(5000, 'y'));
}

TEST_F(DamagedArchive, TakesItsLogAlongWhenItIsSetAside) {
    fill(directory_);
    base::write_file(file(), std::string(5000, 'x'));
    base::write_file(file().string() + "-wal", "log");
    EXPECT_EQ(open().condition, Condition::Replaced);
    EXPECT_THAT(names_in(directory_), testing::Contains("quadrat.db.damaged-20310203-040506-wal"));
}

TEST_F(ArchiveOnDisk, GivesAnOlderWholeGenerationWhenTheLastBecomesUnreadableWhileRunning) {
    Archive archive = std::move(open().archive);
    for (int round = 1; round <= 3; ++round) ASSERT_EQ(archive.append(generation_of(1, round)), std::nullopt);
    Connection(file()).run("UPDATE generation SET deeds='{' WHERE round=3");
    EXPECT_EQ(archive.latest(), generation_of(1, 2));
}

// ---- a disk that does not take it

TEST_F(ArchiveOnDisk, GoesOnInMemoryWhereNothingCanBeWritten) {
    base::write_file(directory_ / "a file", "in the way");
    for (const fs::path& directory : {directory_ / "a file", fs::path("/proc/quadrat"), fs::path("/dev/null/state")}) {
        Archive::Opened opened = Archive::open(directory, kNow);
        EXPECT_EQ(opened.condition, Condition::MemoryOnly);
        EXPECT_THAT(opened.message, HasSubstr("in memory only"));
        EXPECT_EQ(opened.archive.begin_visit(kNow).trouble, std::nullopt);
        EXPECT_EQ(opened.archive.append(generation_of(1, 2)), std::nullopt);
        EXPECT_EQ(opened.archive.latest(), generation_of(1, 2));
    }
}

// Files may grow no further in this process from now on, as on a full disk.
void fill_the_disk(rlim_t bytes) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

TEST_F(ArchiveOnDisk, SaysSoAndKeepsWhatItHasWhenTheDiskIsFull) {
    Archive archive = std::move(open().archive);
    for (int round = 1; round <= 5; ++round) ASSERT_EQ(archive.append(generation_of(1, round)), std::nullopt);
    const rlim_t full = fs::file_size(file().string() + "-wal") + 100;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        fill_the_disk(full);
        Archive::Opened opened = Archive::open(directory_, kNow);
        bool is_said = opened.condition == Condition::MemoryOnly;
        for (int round = 6; round < 20 && !is_said; ++round)
            is_said = opened.archive.append(generation_of(1, round)).has_value();
        ::_exit(is_said && opened.archive.latest() != generation_of(1, 19) ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    EXPECT_GE(archive.latest()->round, 5);
    EXPECT_EQ(archive.append(generation_of(1, 30)), std::nullopt) << "and goes on when there is room again";
    EXPECT_EQ(archive.latest(), generation_of(1, 30));
}

}  // namespace
}  // namespace quadrat::archive
