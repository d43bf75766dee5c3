// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "archive/outbox.hpp"
#include "archive/sqlite.hpp"
#include "base/error.hpp"
#include "unit/archive/archive_fixture.hpp"

namespace quadrat::archive {
namespace {

using Condition = Archive::Condition;
using testing::HasSubstr;

class ArchiveOfVersionOne : public ArchiveOnDisk {
  protected:
    // As the first program wrote it: written down here, so that no later change of ours can change it.
    void write() const {
        Connection file{directory_ / "quadrat.db"};
        file.run(R"(PRAGMA auto_vacuum=INCREMENTAL; PRAGMA journal_mode=WAL;
BEGIN;
CREATE TABLE visit(id INTEGER PRIMARY KEY, began_ms INTEGER NOT NULL, ended_ms INTEGER, ending TEXT, rounds INTEGER);
CREATE TABLE answer(visit INTEGER NOT NULL, round INTEGER NOT NULL, aspect TEXT NOT NULL, candidate INTEGER NOT NULL, at_ms INTEGER NOT NULL, PRIMARY KEY(visit, round, aspect)) WITHOUT ROWID;
CREATE TABLE generation(id INTEGER PRIMARY KEY AUTOINCREMENT, visit INTEGER NOT NULL, round INTEGER NOT NULL, seed TEXT NOT NULL, flight TEXT NOT NULL, breeder TEXT NOT NULL, belief TEXT NOT NULL, offer TEXT NOT NULL, answers TEXT NOT NULL);
CREATE TABLE start(id INTEGER PRIMARY KEY AUTOINCREMENT, at_ms INTEGER NOT NULL);
PRAGMA application_id=1363432020; PRAGMA user_version=1;
INSERT INTO visit VALUES(7, 1000, 2000, 'finished', 6), (8, 3000, NULL, NULL, NULL);
INSERT INTO answer VALUES(7, 1, 'trees', 2, 1500);
COMMIT;)");
    }
    std::int64_t number(const char* sql) const { return Connection{directory_ / "quadrat.db"}.integer(sql); }
};

TEST_F(ArchiveOfVersionOne, IsBroughtUpToDateWithAllThatIsInIt) {
    write();
    Archive::Opened opened = open();
    EXPECT_EQ(opened.condition, Condition::Continued);
    EXPECT_THAT(opened.message, HasSubstr("older version was brought up to date"));
    EXPECT_EQ(opened.archive.begin_visit(kNow).visit, 9);
    EXPECT_EQ(opened.archive.remember("health", "well"), std::nullopt);
    EXPECT_EQ(number("SELECT count(*) FROM visit"), 3);
    EXPECT_EQ(number("SELECT trees FROM generation WHERE visit=7 AND land IS NULL"), 2);
    EXPECT_EQ(number("SELECT trees_ms FROM generation WHERE visit=7"), 1500);
    EXPECT_EQ(opened.archive.latest(), std::nullopt) << "what was answered then is no generation to go on with";
    EXPECT_EQ(number("PRAGMA user_version"), 4);
    EXPECT_EQ(number("PRAGMA page_size"), 512);
}

TEST_F(ArchiveOfVersionOne, CanBeHadBackWithAllThatItHasRoomFor) {
    write();
    {
        Archive::Opened opened = open();
        const auto begun = opened.archive.begin_visit(kNow);
        ASSERT_EQ(opened.archive.append(generation_of(begun.visit, 1)), std::nullopt);
        genome::Pick answers;
        answers[genome::Aspect::Land] = 3;
        ASSERT_EQ(opened.archive.keep_answers(begun.visit, 1, answers, kNow), std::nullopt);
        ASSERT_EQ(opened.archive.remember("health", "well"), std::nullopt);
    }
    EXPECT_EQ(move_state(directory_, 1), 4);
    EXPECT_EQ(number("PRAGMA user_version"), 1);
    EXPECT_EQ(number("SELECT count(*) FROM sqlite_schema WHERE name IN ('memory', 'outbox')"), 0);
    EXPECT_EQ(number("SELECT count(*) FROM visit"), 3);
    EXPECT_EQ(number("SELECT candidate FROM answer WHERE visit=7 AND aspect='trees' AND at_ms=1500"), 2);
    EXPECT_EQ(number("SELECT candidate FROM answer WHERE visit=9 AND aspect='land'"), 3);
    EXPECT_EQ(number("SELECT count(*) FROM generation"), 0) << "it could not go on from what ours keeps of it";
    const Archive::Opened again = open();
    EXPECT_EQ(again.condition, Condition::Continued);
    EXPECT_EQ(number("SELECT land FROM generation WHERE visit=9"), 3);
}

TEST_F(ArchiveOfVersionOne, IsWholeAfterAKillInTheMiddleOfTheMove) {
    for (int round = 0; round < 20; ++round) {
        std::filesystem::remove_all(directory_);
        std::filesystem::create_directory(directory_);
        write();
        const pid_t child = ::fork();
        if (child == 0) {
            const Archive::Opened opened = open();
            ::_exit(0);
        }
        ::usleep(static_cast<useconds_t>(200 * round));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const Archive::Opened opened = open();
        ASSERT_EQ(opened.condition, Condition::Continued) << opened.message;
        EXPECT_TRUE(opened.archive.is_open(8));
    }
}

TEST_F(ArchiveOfVersionOne, MovesNothingThatIsNotOurs) {
    EXPECT_THROW(move_state(directory_, 1), base::InputError);
    write();
    EXPECT_THROW(move_state(directory_, 5), base::InputError);
    EXPECT_THROW(move_state(directory_, 0), base::InputError);
    Connection{directory_ / "quadrat.db"}.run("CREATE TABLE other(x)");
    EXPECT_THROW(move_state(directory_, 2), base::InputError);
    EXPECT_EQ(number("PRAGMA user_version"), 1);
}

TEST_F(ArchiveOnDisk, RemembersTheLastTextUnderEachName) {
    {
        Archive archive = std::move(open().archive);
        EXPECT_EQ(archive.remembered("health"), "");
        ASSERT_EQ(archive.remember("health", "well"), std::nullopt);
        ASSERT_EQ(archive.remember("health", "better"), std::nullopt);
    }
    EXPECT_EQ(open().archive.remembered("health"), "better");
}

TEST_F(ArchiveOnDisk, KeepsMessagesInOrderUntilTheyWereSentAndNoMoreThanItShould) {
    {
        Archive archive = std::move(open().archive);
        for (int i = 0; i < 30; ++i) ASSERT_EQ(archive.post("visits", std::to_string(i), 20), std::nullopt);
    }
    Archive archive = std::move(open().archive);
    EXPECT_FALSE(Outbox::open("/no/such/folder").has_value());
    auto outbox = Outbox::open(directory_);
    ASSERT_TRUE(outbox.has_value());
    const auto first = outbox->waiting(5);
    ASSERT_EQ(first.size(), 5U);
    EXPECT_EQ(first.front().payload, "10");
    ASSERT_EQ(outbox->forget(first.back().id), std::nullopt);
    EXPECT_EQ(outbox->waiting(100).size(), 15U);
    EXPECT_EQ(outbox->waiting(1).front().payload, "15");
}

}  // namespace
}  // namespace quadrat::archive
