// SPDX-License-Identifier: Apache-2.0
#include "tempo/draw_ahead.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace quadrat::tempo {
namespace {

using namespace std::chrono_literals;

constexpr nanoseconds kPeriod{16'666'667};

// Frames that reach a screen one after another.
class Shown {
  public:
    explicit Shown(DrawAhead& ahead, int meant_periods = 1) : ahead_(ahead), meant_periods_(meant_periods) {}
    void after(nanoseconds time) {
        FrameRecord record;
        record.period = kPeriod;
        record.meant_periods = meant_periods_;
        record.shown_before = std::exchange(last_, now + time);
        record.shown = now += time;
        ahead_.shown(record);
    }
    void interrupted() { last_.reset(); }
    DisplayTime now{};

  private:
    DrawAhead& ahead_;
    int meant_periods_;
    std::optional<DisplayTime> last_;
};

TEST(DrawAhead, HappensWhereWaitingCostsFramesAndWaitingIsTriedEverMoreSeldom) {
    DrawAhead ahead;
    Shown shown(ahead);
    int changes = 0, waited = 0, frames = 0;
    bool was_waiting = true;
    while (shown.now.time_since_epoch() < 1h) {
        const bool waits = ahead.waits(shown.now);
        changes += waits != was_waiting;
        was_waiting = waits;
        waited += waits;
        ++frames;
        shown.after(waits ? 2 * kPeriod : kPeriod);  // drawing takes a little more than one period
    }
    EXPECT_LT(waited, frames / 1000) << "hardly a frame is lost by trying";
    EXPECT_GT(changes, 10) << "but it does try";
    EXPECT_LT(changes, 40);
}

// Fed with even frames of two periods each, it used to take every one of them for late, and a press was seen a frame
// later than it could be, for ever.
TEST(DrawAhead, WaitsAtHalfRateWhereFramesAreInTimeForHalfRate) {
    DrawAhead ahead;
    Shown shown(ahead, 2);
    int waited = 0;
    for (int i = 0; i < 36'000; ++i) {
        waited += ahead.waits(shown.now);
        shown.after(2 * kPeriod);
    }
    EXPECT_EQ(waited, 36'000);
}

TEST(DrawAhead, HappensAtHalfRateTooWhereWaitingCostsFrames) {
    DrawAhead ahead;
    Shown shown(ahead, 2);
    int waited = 0;
    for (int i = 0; i < 36'000; ++i) {
        const bool waits = ahead.waits(shown.now);
        waited += waits;
        shown.after(waits ? 3 * kPeriod : 2 * kPeriod);
    }
    EXPECT_LT(waited, 360);
}

TEST(DrawAhead, HappensAfterAFrameThatWouldHaveBeenInTimeThen) {
    DrawAhead ahead;
    Shown shown(ahead);
    int late = 0;
    // One frame in a hundred takes half a period too long.
    for (int i = 0; i < 100'000; ++i) {
        const bool is_late = i % 100 == 99 && ahead.waits(shown.now);
        late += is_late;
        shown.after(is_late ? 2 * kPeriod : kPeriod);
    }
    EXPECT_LE(late, 10) << "of a thousand";
    EXPECT_FALSE(ahead.waits(shown.now));
}

TEST(DrawAhead, IsNotCausedByAHiccupOfSeveralFrames) {
    DrawAhead ahead;
    Shown shown(ahead);
    for (int i = 0; i < 10'000; ++i) {
        shown.after(i % 60 == 59 ? 5 * kPeriod : kPeriod);
        ASSERT_TRUE(ahead.waits(shown.now)) << i;
    }
}

TEST(DrawAhead, IsNotCausedByAScreenThatWasAway) {
    DrawAhead ahead;
    Shown shown(ahead);
    for (int i = 0; i < 10; ++i) {
        shown.interrupted();
        shown.after(10s);
    }
    EXPECT_TRUE(ahead.waits(shown.now));
}

}  // namespace
}  // namespace quadrat::tempo
