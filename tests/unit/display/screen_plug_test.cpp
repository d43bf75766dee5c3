// SPDX-License-Identifier: Apache-2.0
// Plugs, power and cards that come and go, played on a scripted card.
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
