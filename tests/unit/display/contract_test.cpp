// SPDX-License-Identifier: Apache-2.0
// What every display promises, asked of each that can be had without a GPU of its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "display/display.hpp"
#include "display/headless/headless_display.hpp"
#include "display/window/window_display.hpp"
#include "unit/display/drawing.hpp"
#include "unit/display/virtual_desktop.hpp"

namespace quadrat::display {
namespace {

using testing::draw_four_quarters;
using testing::Pixel;
using testing::read_back;

struct Way {
    const char* name;
    bool needs_desktop;
    std::function<std::unique_ptr<Display>(const DisplayOptions&)> open;
};
void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

DisplayOptions sized(int width, int height) {
    DisplayOptions options;
    options.size = {width, height};
    return options;
}

class EveryDisplay : public ::testing::TestWithParam<Way> {
  protected:
    void SetUp() override {
        if (GetParam().needs_desktop) desktop_.emplace();
    }
    std::unique_ptr<Display> open(const DisplayOptions& options) { return GetParam().open(options); }

  private:
    std::optional<testing::VirtualDesktop> desktop_;
};

TEST_P(EveryDisplay, SpeaksGles31AndNamesItsGpu) {
    const auto display = open(sized(320, 200));
    display->begin_frame();
    EXPECT_FALSE(epoxy_is_desktop_gl());
    EXPECT_GE(epoxy_gl_version(), 31);
    EXPECT_THAT(display->description(), ::testing::HasSubstr("320x200"));
    EXPECT_THAT(display->description(), ::testing::HasSubstr("OpenGL ES"));
}

TEST_P(EveryDisplay, HasTheDepthAndStencilThatTheContractNames) {
    const auto display = open(sized(64, 64));
    const Canvas canvas = display->begin_frame();
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer);
    const auto bits = [&canvas](GLenum own, GLenum window, GLenum what) {
        GLint value = 0;
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, canvas.framebuffer == 0 ? window : own, what, &value);
        return value;
    };
    EXPECT_GE(bits(GL_DEPTH_ATTACHMENT, GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE), 24);
    EXPECT_GE(bits(GL_STENCIL_ATTACHMENT, GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE), 8);
    EXPECT_GE(bits(GL_COLOR_ATTACHMENT0, GL_BACK, GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE), 8);
}

TEST_P(EveryDisplay, ShowsTheSamePixelsForTheSameDrawing) {
    const auto display = open(sized(320, 200));
    const Canvas canvas = display->begin_frame();
    ASSERT_EQ(canvas.size, (Size{320, 200}));
    draw_four_quarters(canvas);
    const auto pixels = read_back(canvas);
    const auto at = [&pixels](int x, int y) { return pixels[static_cast<std::size_t>(y * 320 + x)]; };
    EXPECT_EQ(at(5, 5), (Pixel{51, 102, 153, 255}));
    EXPECT_EQ(at(80, 50), (Pixel{255, 0, 0, 255}));
    EXPECT_EQ(at(240, 50), (Pixel{0, 255, 0, 255}));
    EXPECT_EQ(at(80, 150), (Pixel{0, 0, 255, 255}));
    EXPECT_EQ(at(240, 150), (Pixel{255, 255, 255, 255}));
    // The edges too: 0.75 of half of 320 from the middle, so columns 40 to 119 are the left pair's.
    EXPECT_EQ(at(39, 50), (Pixel{51, 102, 153, 255}));
    EXPECT_EQ(at(40, 50), (Pixel{255, 0, 0, 255}));
    EXPECT_EQ(at(119, 50), (Pixel{255, 0, 0, 255}));
    EXPECT_EQ(at(120, 50), (Pixel{51, 102, 153, 255}));
    const auto red = std::count(pixels.begin(), pixels.end(), Pixel{255, 0, 0, 255});
    EXPECT_EQ(red, 80 * 50);
    EXPECT_EQ(display->present().outcome, Outcome::Shown);
}

TEST_P(EveryDisplay, CountsFramesAndTellsWhenEachWasShown) {
    const auto display = open(sized(64, 48));
    Presented before;
    for (std::uint64_t frame = 1; frame <= 5; ++frame) {
        draw_four_quarters(display->begin_frame());
        const Presented now = display->present();
        EXPECT_EQ(now.outcome, Outcome::Shown);
        EXPECT_EQ(now.shown_frame, frame);
        EXPECT_GT(now.shown_at, before.shown_at);
        EXPECT_EQ(now.reason, "");
        before = now;
    }
}

TEST_P(EveryDisplay, SwitchedOffSaysSoAndShowsNothingUntilSwitchedOn) {
    const auto display = open(sized(64, 48));
    display->begin_frame();
    const auto shown = display->present().shown_frame;
    display->set_power(Power::Off);
    EXPECT_FALSE(display->begin_frame().is_seen);
    const Presented off = display->present();
    EXPECT_EQ(off.outcome, Outcome::Off);
    EXPECT_EQ(off.shown_frame, shown);
    EXPECT_NE(off.reason, "");
    display->set_power(Power::On);
    EXPECT_TRUE(display->begin_frame().is_seen);
    EXPECT_EQ(display->present().outcome, Outcome::Shown);
}

TEST_P(EveryDisplay, KeepsItsContextCurrentThroughAnotherDisplaysLife) {
    const auto display = open(sized(32, 32));
    const Canvas first = display->begin_frame();
    {
        const auto other = open_headless(sized(48, 48), "beside");
        EXPECT_NE(other->begin_frame().context, first.context);
        draw_four_quarters(other->begin_frame());
    }
    const Canvas again = display->begin_frame();
    EXPECT_EQ(again.context, first.context);
    draw_four_quarters(again);
    EXPECT_EQ(read_back(again)[0], (Pixel{51, 102, 153, 255}));
}

TEST_P(EveryDisplay, CanBeOpenedAgainAfterItWasClosed) {
    std::uint32_t last = 0;
    for (int i = 0; i < 3; ++i) {
        const auto display = open(sized(32, 32));
        EXPECT_NE(display->begin_frame().context, last) << "a number of a context is never used twice";
        last = display->canvas().context;
        draw_four_quarters(display->canvas());
        EXPECT_EQ(read_back(display->canvas())[0], (Pixel{51, 102, 153, 255}));
    }
}

TEST_P(EveryDisplay, HandsRotationAndMirroringOnAndDrawsUpright) {
    DisplayOptions options = sized(64, 48);
    options.rotation = Rotation::Quarter;
    options.mirroring = Mirroring::Mirrored;
    const auto display = open(options);
    const Canvas canvas = display->begin_frame();
    EXPECT_EQ(canvas.rotation, Rotation::Quarter);
    EXPECT_EQ(canvas.mirroring, Mirroring::Mirrored);
    EXPECT_EQ(canvas.size, (Size{64, 48}));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, EveryDisplay,
    ::testing::Values(Way{"Surfaceless", false,
                          [](const DisplayOptions& options) {
                              return open_headless(options, "test", {HeadlessPlatform::Surfaceless});
                          }},
                      Way{"Device", false,
                          [](const DisplayOptions& options) {
                              return open_headless(options, "test", {HeadlessPlatform::Device});
                          }},
                      Way{"Window", true, [](const DisplayOptions& options) { return open_window(options, "test"); }}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace quadrat::display
