// SPDX-License-Identifier: Apache-2.0
// Every way in which a screen fails in the field, played on a scripted card against the keeper that drives the real
// one.
#include "display/kms/screen_keeper.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>

#include "base/seed.hpp"
#include "unit/display/scripted_screen.hpp"

namespace quadrat::display {
namespace {

using namespace std::chrono_literals;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::ScriptedScreen;

class KeptScreen : public ::testing::Test {
  protected:
    // Presents frames until that much time has gone by.
    Presented run_for(Instant time) {
        const Instant end = screen.now() + time;
        Presented last;
        while (screen.now() < end) last = present();
        return last;
    }
    Presented present() {
        const Presented told = keeper.present();
        EXPECT_GE(told.shown_frame, newest) << "a frame shown is never taken back";
        EXPECT_GE(told.shown_at, latest) << "time never runs backwards";
        EXPECT_EQ(told.reason.empty(), told.outcome == Outcome::Shown) << told.reason;
        newest = told.shown_frame;
        latest = told.shown_at;
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

TEST_F(KeptScreen, ShowsTheFirstFrameAtOnceAndOneARetraceFromThenOn) {
    EXPECT_EQ(present().outcome, Outcome::Shown);
    EXPECT_THAT(screen.journal, ElementsAre("probe", "modeset 0", "flip"));
    const Instant began = screen.now();
    for (int i = 0; i < 60; ++i) EXPECT_EQ(present().outcome, Outcome::Shown);
    EXPECT_NEAR(static_cast<double>((screen.now() - began).count()), 1e9, 2e7);
    EXPECT_EQ(newest, 60U) << "of 61 presented the last is still on its way";
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

TEST_F(KeptScreen, WaitsOutAPlugThatBouncesFiveTimesInTwoSeconds) {
    start_running();
    for (int i = 0; i < 5; ++i) {
        after(400ms * i, [](ScriptedScreen& s) { s.unplug(); });
        after(400ms * i + 200ms, [](ScriptedScreen& s) { s.plug_in(); });
    }
    EXPECT_EQ(run_for(4s).outcome, Outcome::Shown);
    EXPECT_EQ(screen.count("probe"), 1);
    EXPECT_EQ(screen.count("modeset 0"), 1) << "it was away, so it is set up in full, once";
}

TEST_F(KeptScreen, LooksAfterSixSecondsAtAPlugThatNeverStopsBouncing) {
    start_running();
    for (int i = 0; i < 200; ++i) after(100ms * i, [](ScriptedScreen& s) { s.tell(event::PlugMoved{false}); });
    run_for(19s);
    EXPECT_GE(screen.count("probe"), 2);
    EXPECT_LE(screen.count("probe"), 4);
    EXPECT_EQ(screen.count("modeset 0"), 0);
}

TEST_F(KeptScreen, LeavesAGoodPictureAloneWhenAnEventChangesNothing) {
    start_running();
    after(0s, [](ScriptedScreen& s) { s.tell(event::PlugMoved{false}); });
    EXPECT_EQ(run_for(3s).outcome, Outcome::Shown);
    EXPECT_EQ(screen.count("probe"), 1);
    EXPECT_EQ(screen.count("disable") + screen.count("modeset 0"), 0);
}

TEST_F(KeptScreen, FollowsAScreenSwitchedOffAtItsMainsOverNight) {
    start_running();
    after(0s, [](ScriptedScreen& s) { s.unplug(); });
    EXPECT_EQ(run_for(3s).outcome, Outcome::NoScreen);
    EXPECT_EQ(run_for(12h).outcome, Outcome::NoScreen);
    EXPECT_EQ(screen.count("modeset 0"), 0);
    after(0s, [](ScriptedScreen& s) { s.plug_in(); });
    EXPECT_EQ(run_for(2s).outcome, Outcome::Shown);
    EXPECT_EQ(screen.count("modeset 0"), 1);
}

TEST_F(KeptScreen, CountsNoLossThatTurnsOutToBeAScreenSwitchedOff) {
    start_running();
    for (int i = 0; i < 3 * kMostLosses; ++i) {
        after(0s, [](ScriptedScreen& s) { s.are_flips_lost = true; });
        after(2100ms, [](ScriptedScreen& s) { s.unplug(); });
        after(5s, [](ScriptedScreen& s) { s.are_flips_lost = false; });
        after(6s, [](ScriptedScreen& s) { s.plug_in(); });
        ASSERT_EQ(run_for(12s).outcome, Outcome::Shown) << i;
    }
}

TEST_F(KeptScreen, SetsUpAnExchangedScreenAnew) {
    start_running();
    after(0s, [](ScriptedScreen& s) { s.unplug(); });
    after(500ms, [](ScriptedScreen& s) { s.edid = 78, s.plug_in(); });
    EXPECT_EQ(run_for(3s).outcome, Outcome::Shown);
    EXPECT_THAT(screen.journal, Contains("disable"));
    EXPECT_EQ(screen.count("modeset 0"), 1);
    EXPECT_EQ(keeper.state().screen->edid, 78U);
}

TEST_F(KeptScreen, SetsUpALinkThatTheKernelCallsBad) {
    start_running();
    after(0s, [](ScriptedScreen& s) { s.is_link_bad = true, s.tell(event::PlugMoved{false}); });
    EXPECT_EQ(run_for(2s).outcome, Outcome::Shown);
    EXPECT_EQ(screen.count("modeset 0"), 1);
    EXPECT_EQ(run_for(20s).outcome, Outcome::Shown);
    EXPECT_EQ(screen.count("modeset 0"), 1);
}

TEST_F(KeptScreen, FindsABadLinkWithoutAnEvent) {
    start_running();
    screen.is_link_bad = true;
    EXPECT_EQ(run_for(12s).outcome, Outcome::Shown);
    EXPECT_EQ(screen.count("modeset 0"), 1);
}

TEST_F(KeptScreen, IgnoresAScreenThatDropsItsPlugBecauseItWasSwitchedOff) {
    start_running();
    keeper.set_power(Power::Off);
    EXPECT_THAT(screen.journal, Contains("disable"));
    screen.journal.clear();
    for (int i = 0; i < 100; ++i) {
        after(1s * i, [](ScriptedScreen& s) { s.unplug(); });
        after(1s * i + 500ms, [](ScriptedScreen& s) { s.plug_in(); });
    }
    EXPECT_EQ(run_for(110s).outcome, Outcome::Off);
    EXPECT_THAT(screen.journal, ElementsAre()) << "anything done to it would wake it up again";
    keeper.set_power(Power::On);
    EXPECT_EQ(run_for(200ms).outcome, Outcome::Shown);
}

TEST_F(KeptScreen, StaysOffWhenSwitchedOffBeforeThereWasAScreen) {
    screen.is_connected = false;
    run_for(2s);
    keeper.set_power(Power::Off);
    after(1s, [](ScriptedScreen& s) { s.plug_in(); });
    EXPECT_EQ(run_for(30s).outcome, Outcome::Off);
    keeper.set_power(Power::On);
    EXPECT_EQ(run_for(300ms).outcome, Outcome::Shown);
}

TEST_F(KeptScreen, GoesOnWithoutTheCardThatIsPulledAndTakesItBack) {
    start_running();
    after(0s, [](ScriptedScreen& s) {
        s.has_card = false;
        s.tell(event::CardRemoved{});
    });
    EXPECT_EQ(run_for(3s).outcome, Outcome::NoScreen);
    EXPECT_THAT(screen.journal, Contains("close"));
    EXPECT_EQ(phase(), Phase::NoCard);
    after(5s, [](ScriptedScreen& s) {
        s.has_card = true;
        s.tell(event::CardAppeared{});
    });
    EXPECT_EQ(run_for(6s).outcome, Outcome::Shown);
}

TEST_F(KeptScreen, LearnsOfAPulledCardFromItsRefusalWhenNoEventComes) {
    start_running();
    screen.has_card = false;
    EXPECT_EQ(run_for(500ms).outcome, Outcome::NoScreen);
    EXPECT_EQ(phase(), Phase::NoCard);
}

TEST_F(KeptScreen, FindsTheCardAgainThatWasPulledWhileSwitchedOff) {
    start_running();
    keeper.set_power(Power::Off);
    after(0s, [](ScriptedScreen& s) { s.has_card = false, s.tell(event::CardRemoved{}); });
    EXPECT_EQ(run_for(5s).outcome, Outcome::Off);
    EXPECT_THAT(screen.journal, Contains("close"));
    screen.has_card = true;
    keeper.set_power(Power::On);
    EXPECT_EQ(run_for(300ms).outcome, Outcome::Shown);
}

TEST_F(KeptScreen, BeginsANewContextWhenTheGpuLostTheOldOne) {
    start_running();
    screen.is_context_lost = true;
    EXPECT_EQ(run_for(500ms).outcome, Outcome::Shown);
    EXPECT_THAT(screen.journal, Contains("close"));
    EXPECT_EQ(screen.count("modeset 0"), 1);
}

TEST_F(KeptScreen, KeepsTimesInOrderWhenFlipTimesJump) {
    start_running();
    for (const Instant skew : {Instant{-10s}, Instant{10s}, Instant{-1h}, Instant{1h}, Instant{0}}) {
        screen.flip_skew = skew;
        run_for(200ms);
        EXPECT_LE(latest, screen.now() + 1ms);
        EXPECT_GE(latest, screen.now() - 100ms);
    }
}

TEST_F(KeptScreen, NamesACardThatIsNotOursAndTakesItWhenItIs) {
    screen.is_denied = true;
    EXPECT_THAT(run_for(30s).reason, HasSubstr("permission"));
    screen.is_denied = false;
    EXPECT_EQ(run_for(6s).outcome, Outcome::Shown);
}

// Half an hour of anything at all; then a good world again. It must have come to a picture, or to a Fault that the
// ladder explains; and it must never have spun or stood still.
TEST(KeptScreenUnderRandomTrouble, ShowsAPictureAgainWhenTheWorldIsGoodAgain) {
    for (std::uint64_t run = 0; run < 300; ++run) {
        base::RandomStream random{base::Seed{20}.child("trouble").child(run)};
        ScriptedScreen screen;
        ScreenKeeper keeper{screen};
        const auto answer = [&random] { return static_cast<Refusal>(random.below(7)); };
        Power power = Power::On;
        for (int step = 0; step < 200; ++step) {
            switch (random.below(12)) {
                case 0:
                    screen.unplug();
                    break;
                case 1:
                    screen.plug_in();
                    break;
                case 2:
                    screen.edid = random.below(3);
                    break;
                case 3:
                    screen.is_link_bad = true;
                    break;
                case 4:
                    screen.are_flips_lost = !screen.are_flips_lost;
                    break;
                case 5:
                    screen.flip_answers.push_back(answer());
                    break;
                case 6:
                    screen.modeset_answers.push_back(answer());
                    break;
                case 7:
                    screen.has_card = !screen.has_card;
                    if (random.below(2) == 0)
                        screen.tell(screen.has_card ? News{event::CardAppeared{}} : News{event::CardRemoved{}});
                    break;
                case 8:
                    screen.is_context_lost = true;
                    break;
                case 9:
                    screen.flip_skew = std::chrono::milliseconds{random.below(20000)} - 10s;
                    break;
                case 10:
                    power = power == Power::On ? Power::Off : Power::On;
                    keeper.set_power(power);
                    break;
                default:
                    screen.rungs = 1 + static_cast<int>(random.below(4));
                    break;
            }
            const Instant before = screen.now();
            for (int frame = 0; frame < 20; ++frame) {
                const Presented told = keeper.present();
                ASSERT_EQ(told.outcome == Outcome::Off, power == Power::Off && keeper.state().phase != Phase::Fault);
            }
            ASSERT_GT(screen.now(), before) << "run " << run << " spins at step " << step;
            ASSERT_LT(screen.now() - before, 60s) << "run " << run << " stands still at step " << step;
        }
        screen.has_card = screen.is_connected = true;
        screen.are_flips_lost = screen.is_context_lost = screen.is_link_bad = false;
        screen.flip_answers.clear();
        screen.modeset_answers.clear();
        if (power == Power::Off) keeper.set_power(Power::On);
        const Instant good = screen.now();
        Presented last;
        while (screen.now() < good + 40s) last = keeper.present();
        if (keeper.state().phase == Phase::Fault)
            EXPECT_TRUE(keeper.state().losses > kMostLosses || keeper.state().denied_since) << "run " << run;
        else
            EXPECT_EQ(last.outcome, Outcome::Shown) << "run " << run << ": " << last.reason;
    }
}

TEST(RefusalOf, SortsTheKernelsErrorsByWhatCanBeDone) {
    EXPECT_EQ(refusal_of(0), Refusal::None);
    EXPECT_EQ(refusal_of(EBUSY), Refusal::Busy);
    EXPECT_EQ(refusal_of(EACCES), Refusal::NoAccess);
    EXPECT_EQ(refusal_of(EINVAL), Refusal::Invalid);
    EXPECT_EQ(refusal_of(ENOSPC), Refusal::NoRoom);
    EXPECT_EQ(refusal_of(ERANGE), Refusal::NoRoom);
    EXPECT_EQ(refusal_of(ENODEV), Refusal::NoDevice);
    EXPECT_EQ(refusal_of(EIO), Refusal::Other);
}

}  // namespace
}  // namespace quadrat::display
