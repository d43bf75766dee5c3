// SPDX-License-Identifier: Apache-2.0
// Cards, modes and frames that fail in the field, played on a scripted card.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>

#include "base/seed.hpp"
#include "unit/display/kept_screen.hpp"

namespace quadrat::display {
namespace {

using namespace std::chrono_literals;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::KeptScreen;
using testing::ScriptedScreen;

TEST_F(KeptScreen, ShowsTheFirstFrameAtOnceAndOneARetraceFromThenOn) {
    EXPECT_EQ(present().outcome, Outcome::Shown);
    EXPECT_THAT(screen.journal, ElementsAre("probe", "modeset 0", "flip"));
    const Instant began = screen.now();
    for (int i = 0; i < 60; ++i) EXPECT_EQ(present().outcome, Outcome::Shown);
    EXPECT_NEAR(static_cast<double>((screen.now() - began).count()), 1e9, 2e7);
    EXPECT_EQ(newest, 61U) << "each frame is out when present returns";
    EXPECT_EQ(present().period, ScriptedScreen::kPeriod);
}

TEST_F(KeptScreen, WaitsForACardThatAppearsTwentySecondsAfterTheStart) {
    screen.has_card = false;
    after(20s, [](ScriptedScreen& s) { s.has_card = true; });
    EXPECT_EQ(run_for(19900ms).outcome, Outcome::NoScreen);
    EXPECT_EQ(phase(), Phase::NoCard);
    EXPECT_LE(screen.count("probe"), 21) << "looked for once a second";
    EXPECT_EQ(run_for(1500ms).outcome, Outcome::Shown);
}

TEST_F(KeptScreen, TakesACardAtOnceWhenTheKernelAnnouncesIt) {
    screen.has_card = false;
    run_for(60s);
    after(0s, [](ScriptedScreen& s) {
        s.has_card = true;
        s.tell(event::CardAppeared{});
    });
    EXPECT_EQ(run_for(200ms).outcome, Outcome::Shown);
}

TEST_F(KeptScreen, StartsWithoutAScreenAndDrawsOnItAfterItIsPluggedIn) {
    screen.is_connected = false;
    EXPECT_EQ(run_for(12s).outcome, Outcome::NoScreen);
    EXPECT_EQ(phase(), Phase::NoConnector);
    EXPECT_EQ(screen.count("flip"), 0);
    after(0s, [](ScriptedScreen& s) { s.plug_in(); });
    EXPECT_EQ(run_for(1700ms).outcome, Outcome::Shown);
}

TEST_F(KeptScreen, PacesItselfWithoutAScreenInsteadOfSpinning) {
    screen.is_connected = false;
    const Instant began = screen.now();
    for (int i = 0; i < 50; ++i) present();
    EXPECT_GE(screen.now() - began, 4900ms);
}

TEST_F(KeptScreen, FindsAScreenWhosePlugEventNeverCame) {
    screen.is_connected = false;
    run_for(10s);
    screen.is_connected = true;
    EXPECT_EQ(run_for(5300ms).outcome, Outcome::Shown);
}

TEST_F(KeptScreen, NoticesAScreenThatLeftWithoutAnEvent) {
    start_running();
    screen.is_connected = false;
    EXPECT_EQ(run_for(12s).outcome, Outcome::NoScreen);
    EXPECT_THAT(screen.journal, Contains("disable"));
}

TEST_F(KeptScreen, RunsAScreenWithoutAnEdid) {
    screen.edid = 0;
    EXPECT_EQ(run_for(1s).outcome, Outcome::Shown);
}

TEST_F(KeptScreen, TriesTheNextWayWhenTheCardRefusesAMode) {
    screen.modeset_answers = {Refusal::Invalid, Refusal::NoRoom};
    EXPECT_EQ(run_for(200ms).outcome, Outcome::Shown);
    EXPECT_EQ(screen.count("modeset 0") + screen.count("modeset 1") + screen.count("modeset 2"), 3);
    EXPECT_EQ(keeper.state().rung, 2);
}

TEST_F(KeptScreen, ClimbsTheLadderAndEndsInFaultOnlyWhenEveryModeIsRefusedForHalfAMinute) {
    screen.every_modeset = Refusal::Invalid;
    EXPECT_EQ(run_for(29s).outcome, Outcome::Lost);
    EXPECT_EQ(screen.count("close"), 1) << "the card is closed and opened anew on the way";
    EXPECT_EQ(run_for(10s).outcome, Outcome::Fault);
    EXPECT_EQ(screen.count("modeset 0"), kMostLosses + 1);
    screen.every_modeset = Refusal::None;
    EXPECT_EQ(run_for(60s).outcome, Outcome::Fault) << "a fault stays one: the process is to be restarted";
}

TEST_F(KeptScreen, ComesBackWhenTheModesAreAcceptedAgainAfterTheCardWasReopened) {
    start_running();
    screen.every_modeset = Refusal::Invalid;
    after(0s, [](ScriptedScreen& s) { s.is_link_bad = true, s.tell(event::PlugMoved{false}); });
    after(7s, [](ScriptedScreen& s) { s.every_modeset = Refusal::None; });
    EXPECT_EQ(run_for(20s).outcome, Outcome::Shown);
    EXPECT_THAT(screen.journal, Contains("close"));
}

TEST_F(KeptScreen, WarnsOfALateFrameAndGoesOnWhenItComes) {
    start_running();
    screen.are_flips_lost = true;
    after(1s, [](ScriptedScreen& s) {
        s.are_flips_lost = false;
        s.tell(FlipShown{s.now()});
    });
    EXPECT_EQ(run_for(3s).outcome, Outcome::Shown);
    EXPECT_EQ(screen.count("modeset 0"), 0);
}

TEST_F(KeptScreen, SetsTheScreenUpAgainWhenAFrameIsNotShownWithinTwoSeconds) {
    start_running();
    screen.are_flips_lost = true;
    after(1500ms, [](ScriptedScreen& s) { s.are_flips_lost = false; });
    EXPECT_EQ(run_for(3s).outcome, Outcome::Shown);
    EXPECT_THAT(screen.journal, Contains("disable"));
    EXPECT_EQ(screen.count("modeset 0"), 1);
}

TEST_F(KeptScreen, TellsWhichFrameWasShownAndNeverOneOfAScreenThatWasLost) {
    start_running();
    screen.are_flips_lost = true;
    present();
    const std::uint64_t before = newest;
    after(100ms, [](ScriptedScreen& s) { s.every_modeset = Refusal::Other; });
    after(2500ms, [](ScriptedScreen& s) { s.tell(FlipShown{s.now()}); });
    run_for(2800ms);
    EXPECT_EQ(newest, before) << "an event that comes after its screen was lost counts for nothing";
}

TEST_F(KeptScreen, EndsInFaultWhenNoFrameIsEverShown) {
    screen.are_flips_lost = true;
    EXPECT_EQ(run_for(60s).outcome, Outcome::Fault);
    EXPECT_EQ(newest, 0U);
}

TEST_F(KeptScreen, ForgetsItsLossesAfterASteadyMinute) {
    start_running();
    for (int i = 0; i < 3 * kMostLosses; ++i) {
        after(0s, [](ScriptedScreen& s) { s.are_flips_lost = true; });
        after(2100ms, [](ScriptedScreen& s) { s.are_flips_lost = false; });
        ASSERT_EQ(run_for(70s).outcome, Outcome::Shown) << i;
        ASSERT_EQ(keeper.state().losses, 0);
    }
}

TEST_F(KeptScreen, OffersTheSameFrameAgainWhileTheCardIsBusy) {
    start_running();
    screen.flip_answers = {Refusal::Busy, Refusal::Busy, Refusal::Busy};
    const auto before = newest;
    present();
    present();
    EXPECT_EQ(newest, before + 2);
    EXPECT_EQ(screen.count("disable"), 0);
}

TEST_F(KeptScreen, LosesACardThatStaysBusyAndSetsItUpAgain) {
    start_running();
    screen.every_flip = Refusal::Busy;
    after(2050ms, [](ScriptedScreen& s) { s.every_flip = Refusal::None; });
    EXPECT_EQ(run_for(3s).outcome, Outcome::Shown);
    EXPECT_EQ(screen.count("modeset 0"), 1);
}

TEST_F(KeptScreen, RetriesAModesetThatIsBusyBeforeItTriesAnother) {
    screen.modeset_answers = {Refusal::Busy, Refusal::Busy, Refusal::Busy};
    EXPECT_EQ(run_for(600ms).outcome, Outcome::Shown);
    EXPECT_EQ(screen.count("modeset 0"), 4);
}

TEST_F(KeptScreen, TakesAModesetThatStaysBusyForLost) {
    screen.every_modeset = Refusal::Busy;
    EXPECT_EQ(run_for(2500ms).outcome, Outcome::Lost);
    EXPECT_THAT(screen.journal, Contains("disable"));
    screen.every_modeset = Refusal::None;
    EXPECT_EQ(run_for(5s).outcome, Outcome::Shown);
}

TEST_F(KeptScreen, GetsTheScreenBackFromAProgramThatBorrowedIt) {
    start_running();
    screen.every_flip = Refusal::NoAccess;
    screen.every_modeset = Refusal::NoAccess;
    after(6s, [](ScriptedScreen& s) { s.every_flip = s.every_modeset = Refusal::None; });
    EXPECT_EQ(run_for(5s).outcome, Outcome::Lost);
    EXPECT_THAT(present().reason, HasSubstr("another program"));
    EXPECT_EQ(run_for(3s).outcome, Outcome::Shown);
    EXPECT_EQ(keeper.state().losses, 0);
}

TEST_F(KeptScreen, EndsInFaultWhenAnotherProgramKeepsTheScreenForTenSeconds) {
    start_running();
    screen.every_flip = Refusal::NoAccess;
    screen.every_modeset = Refusal::NoAccess;
    EXPECT_EQ(run_for(9500ms).outcome, Outcome::Lost);
    EXPECT_EQ(run_for(2s).outcome, Outcome::Fault);
    EXPECT_THAT(present().reason, HasSubstr("another program"));
}

TEST_F(KeptScreen, SetsTheModeAgainWhenTheCardNoLongerAcceptsItsFrames) {
    start_running();
    screen.flip_answers = {Refusal::Invalid};
    EXPECT_EQ(run_for(300ms).outcome, Outcome::Shown);
    EXPECT_EQ(screen.count("modeset 0"), 1);
}

TEST_F(KeptScreen, GoesToASmallerModeWhenMemoryRunsOutWhileRunningAndStaysThere) {
    start_running();
    screen.flip_answers = {Refusal::NoRoom};
    EXPECT_EQ(run_for(300ms).outcome, Outcome::Shown);
    EXPECT_EQ(keeper.state().rung, 1);
    screen.is_link_bad = true;
    after(0s, [](ScriptedScreen& s) { s.tell(event::PlugMoved{false}); });
    run_for(3s);
    EXPECT_EQ(keeper.state().rung, 1);
}

}  // namespace
}  // namespace quadrat::display
