// SPDX-License-Identifier: Apache-2.0
#include "display/kms/placement.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace quadrat::display {

void PrintTo(Size size, std::ostream* out) { *out << size.width << "x" << size.height; }
void PrintTo(const Placement& placement, std::ostream* out) {
    *out << placement.size.width << "x" << placement.size.height << "+" << placement.x << "+" << placement.y;
}

namespace {

TEST(Placement, FillsTheModeWhenThePictureHasItsShape) {
    EXPECT_EQ(placed_in({3840, 2160}, {1920, 1080}), (Placement{0, 0, {3840, 2160}}));
    EXPECT_EQ(placed_in({1920, 1200}, {1280, 800}), (Placement{0, 0, {1920, 1200}}));
    EXPECT_EQ(placed_in({1366, 768}, {1280, 720}), (Placement{0, 0, {1366, 768}})) << "a bar of one pixel is a blemish";
}

TEST(Placement, LeavesBarsWhereItHasAnother) {
    EXPECT_EQ(placed_in({1920, 1200}, {1280, 720}), (Placement{0, 60, {1920, 1080}}));
    EXPECT_EQ(placed_in({1920, 1080}, {1024, 768}), (Placement{240, 0, {1440, 1080}}));
    EXPECT_EQ(placed_in({1080, 1920}, {1280, 720}), (Placement{0, 656, {1080, 607}}));
}

TEST(Placement, NeverStretchesAndNeverLeavesTheMode) {
    std::mt19937 random{7};
    for (int i = 0; i < 10'000; ++i) {
        const auto side = [&] { return 16 + static_cast<int>(random() % 4080); };
        const Size mode{side(), side()}, picture{side(), side()};
        const Placement placed = placed_in(mode, picture);
        ASSERT_GE(placed.x, 0);
        ASSERT_GE(placed.y, 0);
        ASSERT_LE(placed.x + placed.size.width, mode.width);
        ASSERT_LE(placed.y + placed.size.height, mode.height);
        ASSERT_TRUE(placed.size.width == mode.width || placed.size.height == mode.height);
        const double across = double(placed.size.width) / picture.width,
                     down = double(placed.size.height) / picture.height;
        ASSERT_LE(std::abs(across / down - 1.0),
                  std::max(0.003, 3.0 / std::min(placed.size.width, placed.size.height)));
    }
}

TEST(DrawnFor, AModeUpTo1200LinesIsDrawnAsItIs) {
    for (const Size size : {Size{1920, 1080}, Size{1920, 1200}, Size{1200, 1920}, Size{1600, 1200}, Size{1366, 768}})
        EXPECT_EQ(drawn_for(size), size);
}

TEST(DrawnFor, ALargerModeIsDrawnSmallerInItsVeryShape) {
    EXPECT_EQ(drawn_for({2560, 1440}), (Size{1920, 1080}));
    EXPECT_EQ(drawn_for({3840, 2160}), (Size{1920, 1080}));
    EXPECT_EQ(drawn_for({2160, 3840}), (Size{1080, 1920}));
    for (const Size size : {Size{2560, 1600}, Size{3440, 1440}, Size{4096, 2160}, Size{2048, 1536}, Size{3840, 1600},
                            Size{2732, 2048}, Size{2562, 1442}, Size{4095, 2161}}) {
        const Size drawn = drawn_for(size);
        EXPECT_LE(drawn.width * drawn.height, 1920 * 1080) << size.width;
        EXPECT_GE(drawn.width * drawn.height, 1920 * 1080 * 4 / 5) << size.width;
        EXPECT_EQ(placed_in(size, drawn).size, size) << "no bars";
        EXPECT_EQ(drawn.width % 2 + drawn.height % 2, 0);
    }
}

}  // namespace
}  // namespace quadrat::display
