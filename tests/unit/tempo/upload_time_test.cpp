// SPDX-License-Identifier: Apache-2.0
#include "tempo/upload_time.hpp"

#include <gtest/gtest.h>

namespace quadrat::tempo {
namespace {

using namespace std::chrono_literals;

constexpr base::Instant kFrame = 33ms;
constexpr base::Instant kShare = UploadTime::kMost;
static_assert(kShare < kFrame / UploadTime::kShare);

TEST(UploadTime, IsUnderTwoMillisecondsWhereDrawingLeavesIt) {
    UploadTime time;
    EXPECT_EQ(time.next(kFrame, false), kShare);
    time.drew(10ms);
    EXPECT_EQ(time.next(kFrame, false), kShare);
}

TEST(UploadTime, IsWhatTheSlowestOfTheLastFramesLeaves) {
    UploadTime time;
    time.drew(27ms);
    for (int i = 0; i < 3; ++i) {
        time.drew(10ms);
        const auto given = time.next(kFrame, false);
        ASSERT_TRUE(given);
        EXPECT_LT(*given, kShare);
        EXPECT_LT(27ms + *given, kFrame * 9 / 10);
    }
    time.drew(10ms);  // by now it was long ago
    EXPECT_EQ(time.next(kFrame, false), kShare);
}

TEST(UploadTime, LetsAFewFramesGoByThatHaveNoneAndNoMore) {
    UploadTime time;
    for (int turn = 0; turn < 3; ++turn) {
        for (int i = 0; i < UploadTime::kMostPutOff; ++i) {
            time.drew(32ms);
            EXPECT_FALSE(time.next(kFrame, false)) << turn << ' ' << i;
        }
        time.drew(32ms);
        EXPECT_EQ(time.next(kFrame, false), kShare) << turn;
    }
}

TEST(UploadTime, KeepsNobodyWaiting) {
    UploadTime time;
    time.drew(40ms);
    EXPECT_FALSE(time.next(kFrame, false));
    EXPECT_EQ(time.next(kFrame, true), kFrame / UploadTime::kShare);
}

}  // namespace
}  // namespace quadrat::tempo
