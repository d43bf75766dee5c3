// SPDX-License-Identifier: Apache-2.0
#include "display/options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrat::display {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

template <typename Call>
std::string message_of(Call call) {
    try {
        call();
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(DisplayOptions, ReadsSizesWithinWhatAPiCanDraw) {
    EXPECT_EQ(size_from("1280x720", "--size"), (Size{1280, 720}));
    EXPECT_EQ(size_from("4096x4096", "--size"), (Size{4096, 4096}));
    EXPECT_EQ(size_from("16X16", "--size"), (Size{16, 16}));
}

TEST(DisplayOptions, RefusesSillySizesAndNamesTheOptionAndTheRemedy) {
    for (const char* silly : {"", "1280", "x", "1280x", "x720", "0x0", "15x720", "4097x720", "-1280x720", "1280x-720",
                              "1280x720x3", "1e3x720", "99999999999x720", " 1280x720", "1280 x 720", "0x500x10"})
        EXPECT_THAT(message_of([&] { size_from(silly, "--size"); }),
                    AllOf(HasSubstr("--size"), HasSubstr("1280x720"), HasSubstr("4096")))
            << silly;
}

TEST(DisplayOptions, ReadsModesWithAndWithoutARefreshRate) {
    EXPECT_EQ(mode_from("", "mode"), std::nullopt);
    EXPECT_EQ(mode_from("1920x1080", "mode"), (WantedMode{{1920, 1080}, 0.0}));
    EXPECT_EQ(mode_from("1920x1080@60", "mode"), (WantedMode{{1920, 1080}, 60.0}));
    EXPECT_NEAR(mode_from("1920x1080@59.94", "mode")->refresh_hz, 59.94, 1e-9);
}

TEST(DisplayOptions, RefusesModesThatAreNone) {
    for (const char* silly : {"1080p", "1920x1080@", "1920x1080@0", "1920x1080@inf", "1920x1080@60Hz", "@60",
                              "1920x1080@60.", "1920x1080@1000", "1920x1080@-60"})
        EXPECT_THAT(message_of([&] { mode_from(silly, "display.mode"); }),
                    AllOf(HasSubstr("display.mode"), HasSubstr("1920x1080@60")))
            << silly;
}

TEST(DisplayOptions, NamesEveryKindBothWays) {
    for (const Kind kind : {Kind::Auto, Kind::Kms, Kind::Window, Kind::Headless})
        EXPECT_EQ(kind_from(name_of(kind), "--display"), kind);
    EXPECT_THAT(message_of([] { kind_from("hdmi", "--display"); }),
                AllOf(HasSubstr("--display"), HasSubstr("headless")));
}

TEST(DisplayOptions, AreCheckedBeforeAnythingIsOpened) {
    DisplayOptions options;
    options.kind = Kind::Headless;
    options.size = {8192, 4096};
    EXPECT_THAT(message_of([&] { open_display(options); }), AllOf(HasSubstr("8192x4096"), HasSubstr("4096")));
    options.size = {640, -1};
    EXPECT_THAT(message_of([&] { open_display(options); }), HasSubstr("640x-1"));
    options.size = {};
    options.mode = "huge";
    EXPECT_THAT(message_of([&] { open_display(options); }), HasSubstr("huge"));
}

}  // namespace
}  // namespace quadrat::display
