// SPDX-License-Identifier: Apache-2.0
#include "staff/ladder.hpp"

#include <gtest/gtest.h>

#include "support/process.hpp"

namespace quadrat::staff {
namespace {

using namespace std::chrono_literals;

// A machine whose program fails `life` after each start, and starts again at once; reboots empty the runtime folder.
struct FailingMachine {
    tests::TemporaryFolder folder;
    Seconds uptime{20};
    int starts = 0, safe = 0, reboots = 0;

    FailingMachine() { boot(); }
    void boot() {
        std::filesystem::remove_all(folder / "run");
        std::filesystem::create_directories(folder / "run");
        std::filesystem::create_directories(folder / "state");
        uptime = 20s;
    }
    // Returns false when it was rebooted.
    Rung live(Seconds life) {
        Ladder ladder(folder / "run", folder / "state", uptime);
        ++starts;
        safe += ladder.rung().mode == Mode::Safe;
        const Rung rung = ladder.rung();
        if (rung.remedy == Remedy::Reboot && ladder.note_reboot()) {
            ++reboots;
            boot();
            return rung;
        }
        if (life >= kGoodRun) ladder.note_good_run();
        uptime += life;
        return rung;
    }
};

TEST(Ladder, ThreeFailuresInTenMinutesLeadToSafeMode) {
    FailingMachine machine;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(machine.live(100s).mode, Mode::Usual) << i;
    EXPECT_EQ(machine.live(100s).mode, Mode::Safe);
    EXPECT_EQ(machine.reboots, 0);
}

TEST(Ladder, FailuresFarApartDoNot) {
    FailingMachine machine;
    for (int i = 0; i < 100; ++i) EXPECT_EQ(machine.live(301s).mode, Mode::Usual) << i;
    EXPECT_EQ(machine.reboots, 0);
}

TEST(Ladder, PersistentFailureRebootsThriceAndNeverAgainWithoutAGoodHour) {
    FailingMachine machine;
    for (int i = 0; i < 1000; ++i) machine.live(2s);
    EXPECT_EQ(machine.reboots, kMostReboots);
    EXPECT_EQ(machine.live(2s).mode, Mode::Safe) << "and it goes on in safe mode";
    machine.uptime += 600s;
    machine.live(kGoodRun);
    for (int i = 0; i < 1000; ++i) machine.live(2s);
    EXPECT_EQ(machine.reboots, 2 * kMostReboots) << "a good hour earns the right to it anew";
}

TEST(Ladder, ARebootThatCannotBeWrittenDownIsNotAskedFor) {
    const tests::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "run");
    Ladder ladder(folder / "run", folder / "no/such/folder", 20s);
    EXPECT_FALSE(ladder.note_reboot());
}

TEST(Ladder, AnOrderlyEndIsNoFailure) {
    const tests::TemporaryFolder folder;
    for (int i = 0; i < 20; ++i) {
        Ladder ladder(folder.path(), folder.path(), Seconds{20 + i});
        EXPECT_EQ(ladder.rung().failures, 0);
        ladder.note_end();
    }
}

TEST(Ladder, StaffWishForSafeModeAndForgiveWhatFailed) {
    const tests::TemporaryFolder folder;
    for (int i = 0; i < kFailuresToSafety; ++i) Ladder(folder.path(), folder.path(), Seconds{20 + i});
    Ladder failing(folder.path(), folder.path(), 30s);
    EXPECT_EQ(failing.rung().mode, Mode::Safe);
    failing.forgive();
    failing.note_end();
    EXPECT_EQ(failing.rung().mode, Mode::Usual);
    Ladder next(folder.path(), folder.path(), 40s);
    EXPECT_EQ(next.rung().mode, Mode::Usual) << "what was forgiven is forgotten";
    next.keep_safe();
    EXPECT_EQ(next.rung().mode, Mode::Safe);
    EXPECT_TRUE(next.rung().is_wished);
    EXPECT_EQ(next.rung().failures, 0);
}

TEST(Ladder, WithoutAFolderItNeverClimbs) {
    for (int i = 0; i < 20; ++i) EXPECT_EQ(Ladder("/no/such/folder", "/no/such/folder", 20s).rung().failures, 0);
}

TEST(Ladder, WhatIsWrittenThereByOthersIsNothing) {
    const tests::TemporaryFolder folder;
    for (const char* text :
         {"", "nonsense", "-5 open\n", "99999999999999999999 open\n", "5000 open\n5001 open\n5002 open\n"}) {
        folder.write("starts", text);
        folder.write("reboots", "many");
        EXPECT_EQ(Ladder(folder.path(), folder.path(), 100s).rung().failures, 0) << text;
    }
}

}  // namespace
}  // namespace quadrat::staff
