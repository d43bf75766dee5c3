// SPDX-License-Identifier: Apache-2.0
// The screen's keeper, told for each frame whether to wait for it, as the frame loop does.
#include <utility>

#include "tempo/draw_ahead.hpp"
#include "unit/display/kept_screen.hpp"

namespace quadrat::display::testing {
namespace {

constexpr Instant kPeriod = ScriptedScreen::kPeriod;

class PacedScreen : public KeptScreen {
  protected:
    Presented present_paced() {
        tempo::HandOver how;
        how.then =
            ahead.waits(base::DisplayTime{screen.now()}) ? tempo::HandOver::Then::Wait : tempo::HandOver::Then::Ahead;
        Presented told = present(how);
        for (const tempo::FrameRecord& record : told.finished) ahead.shown(record);
        return told;
    }

    tempo::DrawAhead ahead;
};

TEST_F(PacedScreen, AFastMachineShowsEachFrameWithinOnePeriodOfBeginningIt) {
    start_running();
    Instant oldest{0};
    std::uint64_t first = 0, last = 0;
    Instant first_at{0}, last_at{0};
    for (int i = 0; i < 600; ++i) {
        const Instant begun = screen.now();
        screen.spend(5ms);
        for (const tempo::FrameRecord& record : present_paced().finished) {
            if (first == 0) first = record.number, first_at = record.shown.time_since_epoch();
            last = record.number, last_at = record.shown.time_since_epoch();
            oldest = std::max(oldest, record.shown.time_since_epoch() - begun);
        }
    }
    EXPECT_NEAR(static_cast<double>((last_at - first_at) / kPeriod), static_cast<double>(last - first), 1);
    EXPECT_LE(oldest, 17ms);
}

TEST_F(PacedScreen, WhereFramesAreDrawnAheadAHiccupIsNotSeen) {
    start_running();
    int late = 0, frames = 0;
    for (int i = 0; i < 1000; ++i) {
        screen.spend(i % 50 == 49 ? 20ms : 8ms);
        for (const tempo::FrameRecord& record : present_paced().finished) {
            ++frames;
            late += tempo::is_late(record);
            EXPECT_LE(tempo::took(record), 2 * kPeriod + 1us);
        }
    }
    EXPECT_GE(frames, 990) << "each frame has its record";
    EXPECT_GE(late, 1) << "or nothing is shown";
    EXPECT_LE(late, 3) << "of twenty: each after waiting was tried again";
}

TEST_F(PacedScreen, HandsNoFrameOverBeforeItIsMeantTo) {
    start_running();
    for (int i = 0; i < 100; ++i) {
        tempo::HandOver how;
        how.begun = base::DisplayTime{screen.now()};
        how.meant_periods = 2;
        screen.spend(2ms);
        how.not_before = base::DisplayTime{screen.now() + kPeriod};
        for (const tempo::FrameRecord& record : present(how).finished) {
            EXPECT_GE(record.handed_over, *how.not_before);
            EXPECT_EQ(record.meant_periods, 2);
            EXPECT_GT(record.shown, record.handed_over);
            EXPECT_FALSE(tempo::is_late(record));
        }
    }
}

}  // namespace
}  // namespace quadrat::display::testing
