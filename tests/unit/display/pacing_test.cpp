// SPDX-License-Identifier: Apache-2.0
#include "display/pacing.hpp"

#include <utility>

#include "display/shown_frames.hpp"
#include "unit/display/kept_screen.hpp"

namespace quadrat::display::testing {
namespace {

constexpr Instant kPeriod = ScriptedScreen::kPeriod;

class PacedScreen : public KeptScreen {
  protected:
    // Draws for so long, frame after frame; returns how many periods the last frames took each, and how old the picture
    // is when it is seen, from the moment its drawing began.
    struct Pace {
        double periods_a_frame;
        double age_ms;
    };
    Pace draw(Instant drawing, int frames) {
        Instant first{0}, begun{0}, oldest{0};
        for (int i = 0; i < frames; ++i) {
            begun = screen.now();
            screen.spend(drawing);
            const Presented told = present();
            if (i == frames / 2) first = told.shown_at;
            if (told.shown_frame != 0) oldest = std::max(oldest, told.shown_at - begun);
        }
        const double span = static_cast<double>((latest - first).count());
        return {span / static_cast<double>(kPeriod.count()) / (frames - 1 - frames / 2),
                std::chrono::duration<double, std::milli>(oldest).count()};
    }
};

TEST_F(PacedScreen, AFastMachineShowsEachFrameWithinOnePeriodOfBeginningIt) {
    start_running();
    const Pace pace = draw(5ms, 600);
    EXPECT_NEAR(pace.periods_a_frame, 1, 0.01);
    EXPECT_LE(pace.age_ms, 17);
}

TEST(Pacing, DrawsAheadWhereWaitingCostsFramesAndTriesAgainEverMoreSeldom) {
    Pacing pacing;
    Instant now{0};
    int changes = 0, waited = 0, frames = 0;
    bool was_waiting = true;
    while (now < 1h) {
        const bool waits = pacing.waits(now);
        changes += waits != was_waiting;
        was_waiting = waits;
        waited += waits;
        ++frames;
        now += waits ? 2 * kPeriod : kPeriod;  // drawing takes a little more than one period
        pacing.shown(now, kPeriod);
    }
    EXPECT_LT(waited, frames / 1000) << "hardly a frame is lost by trying";
    EXPECT_GT(changes, 10) << "but it does try";
    EXPECT_LT(changes, 40);
}

TEST(Pacing, DrawsAheadAfterAFrameThatWouldHaveBeenInTimeThen) {
    Pacing pacing;
    Instant now{0};
    int late = 0;
    // One frame in a hundred takes half a period too long.
    for (int i = 0; i < 100'000; ++i) {
        const bool is_hiccup = i % 100 == 99;
        const bool is_late = is_hiccup && pacing.waits(now);
        late += is_late;
        now += is_late ? 2 * kPeriod : kPeriod;
        pacing.shown(now, kPeriod);
    }
    EXPECT_LE(late, 10) << "of a thousand";
    EXPECT_FALSE(pacing.waits(now));
}

TEST_F(PacedScreen, WhereFramesAreDrawnAheadAHiccupIsNotSeen) {
    start_running();
    ShownFrames frames;
    frames.since_last(present());
    Instant before = latest;
    int late = 0;
    for (int i = 0; i < 1000; ++i) {
        screen.spend(i % 50 == 49 ? 20ms : 8ms);
        for (const Instant at : frames.since_last(present())) {
            const Instant took = at - std::exchange(before, at);
            late += took > kPeriod + kPeriod / 4;
            EXPECT_LE(took, 2 * kPeriod + 1us);
        }
    }
    EXPECT_GE(late, 1) << "or nothing is shown";
    EXPECT_LE(late, 3) << "of twenty: each after waiting was tried again";
}

TEST(Pacing, AHiccupOfSeveralFramesChangesNothing) {
    Pacing pacing;
    Instant now{0};
    for (int i = 0; i < 10'000; ++i) {
        now += i % 60 == 59 ? 5 * kPeriod : kPeriod;
        pacing.shown(now, kPeriod);
        ASSERT_TRUE(pacing.waits(now)) << i;
    }
}

TEST(Pacing, AScreenThatWasAwayIsNoLateFrame) {
    Pacing pacing;
    for (int i = 0; i < 10; ++i) {
        pacing.interrupted();
        pacing.shown(i * 10s, kPeriod);
    }
    EXPECT_TRUE(pacing.waits(100s));
}

}  // namespace
}  // namespace quadrat::display::testing
