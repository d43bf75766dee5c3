// SPDX-License-Identifier: Apache-2.0
#include "tempo/cadence.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace quadrat::tempo {
namespace {

using namespace std::chrono_literals;
using Instant = std::chrono::nanoseconds;

// Shows a frame at the beginning of its first period after it was handed over and after the one before it.
struct PlainScreen {
    Instant period = 16ms;
    std::vector<Instant> shown{};

    void take(Instant handed_over_at) {
        Instant at = (handed_over_at / period + 1) * period;
        if (!shown.empty() && at <= shown.back()) at = shown.back() + period;
        shown.push_back(at);
    }
};

// As the loop does it, after two frames so far apart: each frame is waited for, or one is on its way.
std::vector<Instant> gaps_after(Instant first_gap, int periods, bool is_ahead, Instant period) {
    PlainScreen screen{period};
    screen.take(0ms);
    Instant handed_over_at = screen.shown.back() + first_gap - period / 2;
    screen.take(handed_over_at);
    std::vector<Instant> gaps;
    for (int n = 0; n < 20; ++n) {
        Cadence cadence{period, periods, base::DisplayTime{screen.shown.back()}};
        if (is_ahead) {
            cadence.shown_at = base::DisplayTime{screen.shown[screen.shown.size() - 2]};
            cadence.handed_over_at = base::DisplayTime{handed_over_at};
        }
        handed_over_at = hand_over_at(cadence).time_since_epoch();
        const Instant before = screen.shown.back();
        screen.take(handed_over_at);
        gaps.push_back(screen.shown.back() - before);
    }
    return gaps;
}

TEST(Cadence, IsEvenFromTheNextFrameOnWhateverWentBefore) {
    for (const Instant period : {16'666'667ns, 33'333'333ns})
        for (const int periods : {1, 2, 3})
            for (const bool is_ahead : {false, true})
                for (const int first : {1, 2, 3, 5})
                    for (const Instant gap : gaps_after(first * period, periods, is_ahead, period))
                        EXPECT_EQ(gap, periods * period) << periods << is_ahead << first;
}

Instant handed_over(Instant shown_at, Instant handed_over_at) {
    return hand_over_at({16ms, 2, base::DisplayTime{shown_at}, base::DisplayTime{handed_over_at}}).time_since_epoch();
}

TEST(Cadence, OfAFrameThatWasHandedOverBeforeTheOneBeforeItWasShownCountsAWholePeriodForIt) {
    EXPECT_EQ(handed_over(160ms, 150ms), 160ms + 16ms + 4ms + 16ms);
    EXPECT_EQ(handed_over(160ms, 161ms), 160ms + 16ms + 4ms + 16ms);
    EXPECT_EQ(handed_over(160ms, 177ms), 160ms + 32ms + 4ms + 16ms);
}

}  // namespace
}  // namespace quadrat::tempo
