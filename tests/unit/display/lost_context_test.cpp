// SPDX-License-Identifier: Apache-2.0
// What a reset of the GPU leaves: another context, on which all that is drawn is made anew.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "display/headless/headless_display.hpp"

namespace quadrat::display {
namespace {

GLenum reset() { return GL_GUILTY_CONTEXT_RESET; }

// The driver's own answer comes back at the end.
class ResetGpu {
  public:
    ResetGpu() : before_(epoxy_glGetGraphicsResetStatus) { epoxy_glGetGraphicsResetStatus = reset; }
    ~ResetGpu() { epoxy_glGetGraphicsResetStatus = before_; }
    ResetGpu(const ResetGpu&) = delete;
    ResetGpu& operator=(const ResetGpu&) = delete;

  private:
    PFNGLGETGRAPHICSRESETSTATUSPROC before_;
};

TEST(LostContext, IsMadeAnewAndDrawnOn) {
    DisplayOptions options;
    options.size = {64, 32};
    const auto display = open_headless(options, "asked for");
    const Canvas before = display->begin_frame();
    EXPECT_EQ(display->begin_frame().context, before.context) << "nothing was lost";
    {
        const ResetGpu gpu;
        const Canvas after = display->begin_frame();
        EXPECT_NE(after.context, before.context);
        EXPECT_EQ(after.size, before.size);
    }
    const Canvas now = display->begin_frame();
    glBindFramebuffer(GL_FRAMEBUFFER, now.framebuffer);
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    std::array<std::uint8_t, 4> pixel{};
    glReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    EXPECT_EQ(pixel, (std::array<std::uint8_t, 4>{255, 0, 0, 255}));
    EXPECT_EQ(display->present().outcome, Outcome::Shown);
}

}  // namespace
}  // namespace quadrat::display
