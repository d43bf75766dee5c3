// SPDX-License-Identifier: Apache-2.0
#include "tempo/upload_slice.hpp"

#include <gtest/gtest.h>

namespace quadrat::tempo {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds kFrame = 33ms;
constexpr std::chrono::nanoseconds kShare = UploadSlice::kMost;
static_assert(kShare < kFrame / UploadSlice::kShare);

std::optional<std::chrono::nanoseconds> idle_after(UploadSlice& slice) {
    const UploadSlices slices = slice.next(kFrame);
    slice.used(slices, false);
    return slices.idle;
}

TEST(UploadSlice, IsUnderTwoMillisecondsWhereDrawingLeavesIt) {
    UploadSlice slice;
    EXPECT_EQ(idle_after(slice), kShare);
    slice.drew(10ms);
    EXPECT_EQ(idle_after(slice), kShare);
}

TEST(UploadSlice, IsWhatTheSlowestOfTheLastFramesLeaves) {
    UploadSlice slice;
    slice.drew(27ms);
    for (int i = 0; i < 3; ++i) {
        slice.drew(10ms);
        const auto given = idle_after(slice);
        ASSERT_TRUE(given);
        EXPECT_LT(*given, kShare);
        EXPECT_LT(27ms + *given, kFrame * 9 / 10);
    }
    slice.drew(10ms);  // by now it was long ago
    EXPECT_EQ(idle_after(slice), kShare);
}

TEST(UploadSlice, LetsAFewFramesGoByThatHaveNoneAndNoMore) {
    UploadSlice slice;
    for (int turn = 0; turn < 3; ++turn) {
        for (int i = 0; i < UploadSlice::kMostPutOff; ++i) {
            slice.drew(32ms);
            EXPECT_FALSE(idle_after(slice)) << turn << ' ' << i;
        }
        slice.drew(32ms);
        EXPECT_EQ(idle_after(slice), kShare) << turn;
    }
}

TEST(UploadSlice, KeepsNobodyWaiting) {
    UploadSlice slice;
    slice.drew(40ms);
    EXPECT_FALSE(slice.next(kFrame).idle);
    EXPECT_EQ(slice.next(kFrame).awaited, kFrame / UploadSlice::kShare);
}

}  // namespace
}  // namespace quadrat::tempo
