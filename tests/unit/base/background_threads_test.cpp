// SPDX-License-Identifier: Apache-2.0
#include "base/background_threads.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <thread>

namespace quadrat::base {
namespace {

bool may_raise_to_ten() {
    rlimit limit{};
    return ::getrlimit(RLIMIT_NICE, &limit) == 0 && (::geteuid() == 0 || limit.rlim_cur >= 10);
}

int nice_of_this_thread() { return ::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid())); }

TEST(BackgroundThreads, RunInIdleTimeUntilSomebodyWaitsAndAreNicerThanOthersThen) {
    const int idle = may_raise_to_ten() ? SCHED_IDLE : SCHED_OTHER;
    BackgroundThreads threads;
    std::jthread([&] {
        threads.enter();
        EXPECT_EQ(nice_of_this_thread(), 10);
        EXPECT_EQ(::sched_getscheduler(0), idle);
        std::jthread([&] { threads.set_awaited(true); }).join();
        EXPECT_EQ(::sched_getscheduler(0), SCHED_OTHER);
        EXPECT_EQ(nice_of_this_thread(), 10);
        threads.set_awaited(false);
        EXPECT_EQ(::sched_getscheduler(0), idle);
        threads.leave();
        threads.set_awaited(true);
        EXPECT_EQ(::sched_getscheduler(0), idle);
    }).join();
    EXPECT_EQ(::sched_getscheduler(0), SCHED_OTHER);
    EXPECT_EQ(nice_of_this_thread(), 0);
}

TEST(BackgroundThreads, WhoeverEntersWhileSomebodyWaitsTakesItsShare) {
    BackgroundThreads threads;
    threads.set_awaited(true);
    std::jthread([&] {
        {
            const BackgroundThreads::Stay stay(threads);
            EXPECT_EQ(::sched_getscheduler(0), SCHED_OTHER);
            EXPECT_EQ(nice_of_this_thread(), 10);
        }
        threads.set_awaited(false);
        EXPECT_EQ(::sched_getscheduler(0), SCHED_OTHER) << "it has left";
    }).join();
}

}  // namespace
}  // namespace quadrat::base
