// SPDX-License-Identifier: Apache-2.0
// A pulled plug, as near as a process can come to one: SIGKILL at any moment. Ten files, a hundred
// kills each: a thousand, in tests short enough for a sanitizer on a busy machine.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/owned.hpp"
#include "unit/archive/archive_fixture.hpp"

namespace quadrat::archive {
namespace {

constexpr Retention kRetention{10, 25};  // small, so that kills also fall into forgetting and vacuuming

struct Pipe {
    base::OwnedDescriptor read;
    base::OwnedDescriptor write;
};

Pipe open_pipe() {
    int ends[2];
    EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    return {base::OwnedDescriptor(ends[0]), base::OwnedDescriptor(ends[1])};
}

// In the child: breeds as fast as it can from the round that was kept, and tells each round once it is kept.
[[noreturn]] void breed_until_killed(const std::filesystem::path& directory, int told) {
    Archive archive = std::move(Archive::open(directory, kNow, kRetention).archive);
    const std::optional<Generation> last = archive.latest();
    for (int round = last ? last->round + 1 : 1;; ++round) {
        if (archive.append(generation_of(1, round)).has_value()) ::_exit(1);
        if (::write(told, &round, sizeof round) != sizeof round) ::_exit(2);
        genome::Pick answers;
        answers[genome::Aspect::Trees] = static_cast<std::size_t>(round % 4);
        if (archive.keep_answers(1, round, answers, kNow).has_value()) ::_exit(3);
    }
}

// Waits until the child has kept none to three rounds, then for a random while, so that the kill falls anywhere, and on
// a busy machine as late as on an idle one.
void kill_at_a_random_moment(pid_t child, int told, int& last_told, base::RandomStream& chance) {
    for (std::uint32_t rounds = chance.below(4); rounds > 0; --rounds) {
        pollfd next{told, POLLIN, 0};
        ASSERT_EQ(::poll(&next, 1, 10'000), 1) << "the child is stuck";
        ASSERT_EQ(::read(told, &last_told, sizeof last_told), static_cast<ssize_t>(sizeof last_told));
    }
    const timespec pause{0, static_cast<long>(chance.below(3'000'000))};
    ::nanosleep(&pause, nullptr);
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the child ended by itself with " << WEXITSTATUS(status);
}

int last_told(int told, int before) {
    int round = before;
    while (::read(told, &round, sizeof round) == sizeof round) {
    }
    return round;
}

class KilledArchive : public ArchiveOnDisk, public testing::WithParamInterface<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Files, KilledArchive, testing::Range<std::uint64_t>(0, 10));

TEST_P(KilledArchive, LosesNoToldRoundInAHundredKillsAtRandomMoments) {
    // What a killed process has written is there whether or not it was flushed, so memory does, and takes seconds.
    if (::access("/dev/shm", W_OK) == 0) use_directory_in("/dev/shm");
    base::RandomStream chance(base::Seed{20}.child(GetParam()));
    int told_round = 0;
    int rounds_lost_in_the_telling = 0;
    for (int kill = 0; kill < 100; ++kill) {
        Pipe pipe = open_pipe();
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) breed_until_killed(directory_, pipe.write.get());
        pipe.write.reset();
        kill_at_a_random_moment(child, pipe.read.get(), told_round, chance);
        if (HasFatalFailure()) FAIL() << "kill " << kill;
        told_round = last_told(pipe.read.get(), told_round);

        const Archive::Opened opened = open(kRetention);
        ASSERT_NE(opened.condition, Archive::Condition::Replaced) << opened.message << ", kill " << kill;
        ASSERT_NE(opened.condition, Archive::Condition::MemoryOnly) << opened.message << ", kill " << kill;
        const std::optional<Generation> latest = opened.archive.latest();
        const int kept = latest ? latest->round : 0;
        ASSERT_GE(kept, told_round) << "kill " << kill;
        ASSERT_LE(kept, told_round + 1) << "kill " << kill;
        if (latest) {
            ASSERT_EQ(latest->deeds, generation_of(1, kept).deeds) << "kill " << kill;
        }
        rounds_lost_in_the_telling += kept - told_round;
        told_round = kept;
    }
    EXPECT_GT(told_round, 100) << "the children did breed";
    RecordProperty("kept_but_not_told", rounds_lost_in_the_telling);
}

}  // namespace
}  // namespace quadrat::archive
