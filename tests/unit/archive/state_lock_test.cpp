// SPDX-License-Identifier: Apache-2.0
#include "archive/state_lock.hpp"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "unit/archive/archive_fixture.hpp"

namespace quadrat::archive {
namespace {

using testing::HasSubstr;

class StateLockOnDisk : public ArchiveOnDisk {
  protected:
    LockAttempt attempt(const char* what) const { return try_lock(directory_, {what, "", "", "", "kill it"}); }
};

TEST_F(StateLockOnDisk, IsHeldByOneAndSaysWhoThatIs) {
    EXPECT_FALSE(holder_of(directory_)) << "nobody came yet";
    const LockAttempt first = attempt("the exhibit");
    ASSERT_TRUE(first.lock) << first.trouble;
    const LockAttempt second = attempt("quadrat words train");
    EXPECT_FALSE(second.lock);
    ASSERT_TRUE(second.holder);
    EXPECT_EQ(second.holder->what, "the exhibit");
    EXPECT_EQ(second.holder->process, std::to_string(::getpid()));
    EXPECT_FALSE(second.holder->host.empty());
    EXPECT_THAT(second.holder->since, HasSubstr(" UTC"));
    EXPECT_EQ(holder_of(directory_), second.holder);
}

TEST_F(StateLockOnDisk, LookingWhoHoldsItTakesItFromNobody) {
    const LockAttempt first = attempt("the exhibit");
    for (int i = 0; i < 100; ++i) EXPECT_TRUE(holder_of(directory_));
    EXPECT_FALSE(attempt("another").lock);
}

TEST_F(StateLockOnDisk, IsFreeAgainAtItsEnd) {
    { const LockAttempt first = attempt("the exhibit"); }
    EXPECT_FALSE(holder_of(directory_)) << "what the file still says means nothing";
    EXPECT_TRUE(attempt("another").lock);
}

TEST_F(StateLockOnDisk, OfAProcessThatWasKilledIsFreeAtOnce) {
    int told[2];
    ASSERT_EQ(::pipe(told), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        const LockAttempt mine = attempt("the exhibit");
        if (!mine.lock || ::write(told[1], "x", 1) != 1) ::_exit(1);
        for (;;) ::pause();
    }
    char byte = 0;
    ASSERT_EQ(::read(told[0], &byte, 1), 1);
    const auto holder = holder_of(directory_);
    ASSERT_TRUE(holder);
    EXPECT_EQ(holder->process, std::to_string(child));
    ::kill(child, SIGKILL);
    ASSERT_EQ(::waitpid(child, nullptr, 0), child);
    EXPECT_TRUE(attempt("another").lock);
    ::close(told[0]);
    ::close(told[1]);
}

TEST_F(StateLockOnDisk, WhoCannotDoWithoutIsToldWhoHasItAndWhatEndsThat) {
    const LockAttempt first = attempt("the exhibit");
    try {
        lock_or_refuse(directory_, {"another", "", "", "", ""});
        FAIL() << "two hold it";
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(directory_.string() + " is in use by the exhibit (process "));
        EXPECT_THAT(error.what(), HasSubstr("end that first: kill it"));
    }
}

TEST_F(StateLockOnDisk, OfAFolderThatIsMissingIsTroubleAndMakesNone) {
    const LockAttempt none = try_lock(directory_ / "nowhere", {"the exhibit", "", "", "", ""});
    EXPECT_FALSE(none.lock);
    EXPECT_FALSE(none.holder);
    EXPECT_THAT(none.trouble, HasSubstr("nowhere/lock"));
    EXPECT_FALSE(std::filesystem::exists(directory_ / "nowhere"));
}

TEST_F(StateLockOnDisk, ThatRootMadeInAnothersFolderIsTheirs) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root can give something away";
    constexpr uid_t kSomebody = 12345;
    ASSERT_EQ(::chown(directory_.c_str(), kSomebody, kSomebody), 0);
    EXPECT_TRUE(attempt("quadrat words train").lock);
    struct stat facts {};
    ASSERT_EQ(::stat((directory_ / "lock").c_str(), &facts), 0);
    EXPECT_EQ(facts.st_uid, kSomebody);
}

}  // namespace
}  // namespace quadrat::archive
