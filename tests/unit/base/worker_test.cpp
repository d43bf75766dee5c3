// SPDX-License-Identifier: Apache-2.0
#include "base/worker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <stdexcept>

namespace quadrat::base {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using enum WorkerOptions::WhenFull;
using enum WorkerOptions::AtEnd;

// A task that is under way until it is let go.
class Gate {
  public:
    Worker::Task task() {
        return [this, opened = open_.get_future().share()] {
            begun_.set_value();
            opened.wait();
        };
    }
    void wait_until_begun() { begun_.get_future().wait(); }
    void open() { open_.set_value(); }

  private:
    std::promise<void> begun_, open_;
};

TEST(Worker, DoesOneTaskAfterAnotherInTheOrderInWhichTheyWereSent) {
    std::vector<int> done;  // of the worker's one thread, until it has finished
    Worker worker({.name = "test", .bound = 100});
    for (int i = 0; i < 50; ++i) EXPECT_TRUE(worker.send([&done, i] { done.push_back(i); }));
    worker.finish();
    ASSERT_EQ(done.size(), 50U);
    EXPECT_TRUE(std::ranges::is_sorted(done));
}

TEST(Worker, RefusesWhatIsOverItsBoundWithoutAWait) {
    Gate gate;
    std::atomic<int> done{0};
    Worker worker({.name = "test", .bound = 3, .when_full = Refuse});
    worker.send(gate.task());
    int taken = 0;
    for (int i = 0; i < 100; ++i) taken += worker.send([&done] { ++done; });
    EXPECT_EQ(taken, 2);
    gate.open();
    worker.finish();
    EXPECT_EQ(done, 2);
    EXPECT_TRUE(worker.send([&done] { ++done; })) << "there is room again";
    worker.finish();
    EXPECT_EQ(done, 3);
}

TEST(Worker, DropsTheOldestThatWaitsForTheNewest) {
    Gate gate;
    std::vector<int> done;
    Worker worker({.name = "test", .bound = 3, .when_full = DropOldest});
    worker.send(gate.task());
    gate.wait_until_begun();
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(worker.send([&done, i] { done.push_back(i); }));
    gate.open();
    worker.finish();
    EXPECT_THAT(done, ElementsAre(8, 9));
}

TEST(Worker, HasItsSenderWaitForRoomWhereItIsToldTo) {
    std::atomic<int> under_way{0}, most{0};
    Worker worker({.name = "test", .bound = 3, .when_full = Wait, .threads = 3});
    for (int i = 0; i < 30; ++i)
        EXPECT_TRUE(worker.send([&] {
            const int now = ++under_way;
            for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
            }
            std::this_thread::sleep_for(1ms);
            --under_way;
        }));
    worker.finish();
    EXPECT_EQ(under_way, 0);
    EXPECT_LE(most, 3);
    EXPECT_GE(most, 2) << "on three threads";
}

TEST(Worker, FinishesOrDropsAtItsEndWhatHasNotBegun) {
    for (const auto at_end : {Finish, Drop}) {
        Gate gate;
        std::atomic<int> done{0};
        std::thread opener;
        {
            Worker worker({.name = "test", .bound = 9, .at_end = at_end});
            worker.send(gate.task());
            gate.wait_until_begun();
            for (int i = 0; i < 5; ++i) worker.send([&done] { ++done; });
            worker.send_at(std::chrono::steady_clock::now() + 1h, [&done] { ++done; });
            opener = std::thread([&gate] {
                std::this_thread::sleep_for(20ms);
                gate.open();
            });
        }
        opener.join();
        EXPECT_EQ(done, at_end == Finish ? 6 : 0);
    }
}

TEST(Worker, DropsWhatWaitsWhenItIsTold) {
    Gate gate;
    std::atomic<int> done{0};
    Worker worker({.name = "test", .bound = 9});
    worker.send(gate.task());
    gate.wait_until_begun();
    worker.send([&done] { ++done; });
    const Begun<void> dropped = worker.begin([&done] { ++done; });
    worker.drop_waiting();
    EXPECT_TRUE(dropped.is_over());
    worker.send([&done] { done += 10; });
    gate.open();
    worker.finish();
    EXPECT_EQ(done, 10);
}

TEST(Worker, BeginsWhatIsSentForLaterNoSoonerAndBehindWhatIsDueBefore) {
    std::vector<int> done;
    Worker worker({.name = "test", .bound = 9});
    const auto begun = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point at;
    worker.send_at(begun + 60ms, [&] {
        done.push_back(3);
        at = std::chrono::steady_clock::now();
    });
    worker.send_at(begun + 30ms, [&] { done.push_back(2); });
    worker.send([&] { done.push_back(1); });
    worker.finish();
    EXPECT_THAT(done, ElementsAre(1, 2, 3));
    EXPECT_GE(at - begun, 60ms);
}

TEST(Worker, HandsOverResultsAndWhatWasThrown) {
    Gate gate;
    Worker worker({.name = "test", .bound = 2});
    EXPECT_EQ(worker.begin([] { return 42; }).get(), 42);
    EXPECT_THROW(worker.begin([]() -> int { throw std::runtime_error("no"); }).get(), std::runtime_error);
    worker.send(gate.task());
    worker.send([] {});
    EXPECT_FALSE(worker.begin([] { return 1; }).is_something()) << "there was no room";
    gate.open();
}

TEST(Worker, HasRoomAsSoonAsWhatItBeganIsOver) {
    Worker worker({.name = "test"});
    for (int i = 0; i < 1000; ++i) {
        const Begun<int> begun = worker.begin([i] { return i; });
        ASSERT_TRUE(begun.is_something());
        while (!begun.is_over()) std::this_thread::yield();
    }
}

TEST(Worker, IsWaitedForBeforeWhatItUsesGoes) {
    Worker worker({.name = "test"});
    std::atomic<bool> is_done{false};
    {
        const Begun<void> begun = worker.begin([&is_done] {
            std::this_thread::sleep_for(20ms);
            is_done = true;
        });
        EXPECT_FALSE(begun.is_over());
    }
    EXPECT_TRUE(is_done);
}

TEST(Worker, SaysItsNameAndRunsInTheBackgroundWhereItIsToldTo) {
    std::array<char, 16> name{};
    int nice = 0;
    Worker worker({.name = "gardener", .priority = WorkerOptions::Priority::Background});
    worker.send([&] {
        ::pthread_getname_np(::pthread_self(), name.data(), name.size());
        nice = ::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()));
    });
    worker.finish();
    EXPECT_STREQ(name.data(), "gardener");
    EXPECT_EQ(nice, 10);
}

}  // namespace
}  // namespace quadrat::base
