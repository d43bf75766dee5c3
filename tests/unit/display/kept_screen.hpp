// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "display/kms/screen_keeper.hpp"
#include "unit/display/scripted_screen.hpp"

// The keeper that drives the real card, on a scripted one.
namespace quadrat::display::testing {

using namespace std::chrono_literals;

class KeptScreen : public ::testing::Test {
  protected:
    // Presents frames until that much time has gone by.
    Presented run_for(Instant time) {
        const Instant end = screen.now() + time;
        Presented last;
        while (screen.now() < end) last = present();
        return last;
    }
    Presented present(const tempo::HandOver& how = {}) {
        const Presented told = keeper.present(how);
        EXPECT_GE(told.shown_frame, newest) << "a frame shown is never taken back";
        EXPECT_GE(told.shown_at.time_since_epoch(), latest) << "time never runs backwards";
        EXPECT_EQ(told.reason.empty(), told.outcome == Outcome::Shown) << told.reason;
        newest = told.shown_frame;
        latest = told.shown_at.time_since_epoch();
        return told;
    }
    void start_running() {
        ASSERT_EQ(run_for(200ms).outcome, Outcome::Shown);
        screen.journal.clear();
    }
    void after(Instant delay, std::function<void(ScriptedScreen&)> happens) {
        screen.at(screen.now() + delay, std::move(happens));
    }
    Phase phase() const { return keeper.state().phase; }

    ScriptedScreen screen;
    ScreenKeeper keeper{screen};
    std::uint64_t newest = 0;
    Instant latest{0};
};

}  // namespace quadrat::display::testing
