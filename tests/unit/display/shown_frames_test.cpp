// SPDX-License-Identifier: Apache-2.0
#include "display/shown_frames.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace quadrat::display::testing {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Presented told(std::uint64_t frame, std::chrono::nanoseconds at) { return {Outcome::Shown, frame, at, 16ms, {}}; }

TEST(ShownFrames, AreTheLatestWhereEachIsWaitedFor) {
    ShownFrames frames;
    EXPECT_THAT(frames.since_last(told(1, 100ms)), ElementsAre(100ms));
    EXPECT_THAT(frames.since_last(told(2, 116ms)), ElementsAre(116ms));
}

TEST(ShownFrames, AreNoneWhereItChangesToDrawingAheadAndTwoWhereItChangesBack) {
    ShownFrames frames;
    frames.since_last(told(7, 100ms));
    EXPECT_THAT(frames.since_last(told(7, 100ms)), IsEmpty());
    EXPECT_THAT(frames.since_last(told(8, 116ms)), ElementsAre(116ms));
    EXPECT_THAT(frames.since_last(told(10, 148ms)), ElementsAre(132ms, 148ms));
}

TEST(ShownFrames, ThatWereNeverShownAreNotMadeUp) {
    ShownFrames frames;
    EXPECT_THAT(frames.since_last(told(0, 0ms)), IsEmpty());
    frames.since_last(told(3, 100ms));
    EXPECT_THAT(frames.since_last(told(40, 5s)), ElementsAre(5000ms));
}

}  // namespace
}  // namespace quadrat::display::testing
