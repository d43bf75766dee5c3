// SPDX-License-Identifier: Apache-2.0
#include "render/gl/rasteriser_threads.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <unistd.h>

#include <latch>
#include <thread>
#include <vector>

namespace quadrat::render::gl {
namespace {

cpu_set_t cores_of(pid_t thread) {
    cpu_set_t cores;
    CPU_ZERO(&cores);
    EXPECT_EQ(::sched_getaffinity(thread, sizeof cores, &cores), 0);
    return cores;
}

bool are_same(const cpu_set_t& a, const cpu_set_t& b) { return CPU_EQUAL(&a, &b) != 0; }

// Threads of that name, which do nothing until this ends.
class Idlers {
  public:
    explicit Idlers(int count) : started_(count) {
        for (int i = 0; i < count; ++i)
            threads_.emplace_back([this, i] {
                ids_[static_cast<std::size_t>(i)] = ::gettid();
                ::pthread_setname_np(::pthread_self(), "idler-0");
                started_.count_down();
                ended_.wait();
            });
        started_.wait();
    }
    ~Idlers() { ended_.count_down(); }
    const std::vector<pid_t>& ids() const { return ids_; }

  private:
    std::latch started_;
    std::latch ended_{1};
    std::vector<pid_t> ids_ = std::vector<pid_t>(2);
    std::vector<std::jthread> threads_;
};

TEST(RasteriserThreads, KeepOffTheCoreOfTheThreadThatFeedsThemAndMayGoAnywhereAgain) {
    const cpu_set_t before = cores_of(0);
    if (CPU_COUNT(&before) < 2) GTEST_SKIP() << "on a single core there is nothing to keep off";
    const Idlers idlers(2);
    const auto threads = RasteriserThreads::of_this_process("idler-");
    ASSERT_EQ(threads.count(), 2U);
    {
        const RasteriserThreads::Feeding feeding(threads);
        const cpu_set_t own = cores_of(0);
        ASSERT_EQ(CPU_COUNT(&own), 1);
        EXPECT_TRUE(CPU_ISSET(static_cast<std::size_t>(::sched_getcpu()), &own));
        cpu_set_t others;
        CPU_XOR(&others, &before, &own);
        for (const pid_t id : idlers.ids()) EXPECT_TRUE(are_same(cores_of(id), others));
    }
    EXPECT_TRUE(are_same(cores_of(0), before));
    for (const pid_t id : idlers.ids()) EXPECT_TRUE(are_same(cores_of(id), before));
}

TEST(RasteriserThreads, WithNoOtherCoreNobodyIsMoved) {
    const Idlers idlers(2);
    std::jthread([&] {
        const int core = ::sched_getcpu();
        cpu_set_t own;
        CPU_ZERO(&own);
        CPU_SET(static_cast<std::size_t>(core), &own);
        for (const pid_t id : idlers.ids()) ASSERT_EQ(::sched_setaffinity(id, sizeof own, &own), 0);
        ASSERT_EQ(::sched_setaffinity(0, sizeof own, &own), 0);
        const auto threads = RasteriserThreads::of_this_process("idler-");
        {
            const RasteriserThreads::Feeding feeding(threads);
            for (const pid_t id : idlers.ids()) EXPECT_TRUE(are_same(cores_of(id), own));
        }
        for (const pid_t id : idlers.ids()) EXPECT_TRUE(are_same(cores_of(id), own));
    }).join();
}

TEST(RasteriserThreads, WhereNoneAreKnownTheCallerMayGoWhereItMight) {
    const cpu_set_t before = cores_of(0);
    const auto none = RasteriserThreads::of_this_process("nobody-");
    EXPECT_EQ(none.count(), 0U);
    const RasteriserThreads::Feeding feeding(none);
    EXPECT_TRUE(are_same(cores_of(0), before));
}

TEST(RasteriserThreads, OneThatHasEndedIsNoObstacle) {
    const cpu_set_t before = cores_of(0);
    RasteriserThreads threads;
    {
        const Idlers idlers(2);
        threads = RasteriserThreads::of_this_process("idler-");
    }
    { const RasteriserThreads::Feeding feeding(threads); }
    EXPECT_TRUE(are_same(cores_of(0), before));
}

}  // namespace
}  // namespace quadrat::render::gl
