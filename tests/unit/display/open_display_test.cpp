// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/error.hpp"
#include "display/display.hpp"
#include "display/kms/drm_card.hpp"
#include "unit/display/drawing.hpp"
#include "unit/display/virtual_desktop.hpp"

namespace quadrat::display {
namespace {

using ::testing::HasSubstr;

DisplayOptions automatic() {
    DisplayOptions options;
    options.size = {64, 48};
    return options;
}

TEST(OpenDisplay, IsHeadlessByItselfOnlyWhereThereIsNoDesktopAndSaysWhy) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    const auto display = open_display(automatic());
    if (display->kind() == "kms") GTEST_SKIP() << "this machine has a screen of its own: " << display->why();
    EXPECT_EQ(display->kind(), "headless");
    EXPECT_THAT(display->why(), HasSubstr("DISPLAY"));
}

TEST(OpenDisplay, PrefersAWindowOnADesktop) {
    const testing::VirtualDesktop desktop;
    const auto display = open_display(automatic());
    EXPECT_EQ(display->kind(), "window") << display->why();
}

TEST(OpenDisplay, FallsBackToHeadlessWhenTheDesktopIsGone) {
    std::string gone;
    {
        const testing::VirtualDesktop desktop;
        gone = desktop.name();
    }
    setenv("DISPLAY", gone.c_str(), 1);
    const auto display = open_display(automatic());
    unsetenv("DISPLAY");
    EXPECT_EQ(display->kind(), "headless");
    EXPECT_THAT(display->why(), HasSubstr("X11"));
}

TEST(OpenDisplay, AWindowAskedForWithoutADesktopIsRefusedWithTheRemedy) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    DisplayOptions options = automatic();
    options.kind = Kind::Window;
    try {
        open_display(options);
        FAIL() << "opened a window without a desktop";
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("--display headless"));
    }
}

TEST(OpenDisplay, AWindowWithoutASizeTakesTheWholeMonitor) {
    const testing::VirtualDesktop desktop;
    DisplayOptions options;
    options.kind = Kind::Window;
    const auto display = open_display(options);
    EXPECT_EQ(display->begin_frame().size, (Size{1280, 800}));
}

TEST(OpenDisplay, KmsAskedForWaitsWithoutACardInsteadOfTakingAnotherDisplay) {
    if (!card_paths().empty()) GTEST_SKIP() << "this machine has a card, which is not for tests to take";
    DisplayOptions options = automatic();
    options.kind = Kind::Kms;
    const auto display = open_display(options);
    EXPECT_EQ(display->kind(), "kms");
    EXPECT_EQ(display->begin_frame().context, 0U);
    const Presented told = display->present();
    EXPECT_EQ(told.outcome, Outcome::NoScreen);
    EXPECT_THAT(told.reason, HasSubstr("/dev/dri"));
    display->set_power(Power::Off);
    EXPECT_EQ(display->present().outcome, Outcome::Off);
}

TEST(OpenDisplay, HeadlessGoesUpToTheLargestSideAndDrawsToItsFarCorner) {
    DisplayOptions options;
    options.kind = Kind::Headless;
    options.size = {kLargestSide, kLargestSide};
    const auto display = open_display(options);
    const Canvas canvas = display->begin_frame();
    testing::draw_four_quarters(canvas);
    testing::Pixel corner{};
    glReadPixels(kLargestSide - 1, kLargestSide - 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, corner.data());
    EXPECT_EQ(corner, (testing::Pixel{51, 102, 153, 255}));
}

}  // namespace
}  // namespace quadrat::display
