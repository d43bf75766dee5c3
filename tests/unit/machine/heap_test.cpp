// SPDX-License-Identifier: Apache-2.0
#include "machine/heap.hpp"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cstring>

#include "display/headless/headless_display.hpp"
#include "machine/measurement.hpp"
#include "render/gl/program.hpp"

namespace quadrat::machine {
namespace {

TEST(Heap, ACompilerIsLetGoAndComesBackWhenItIsNeeded) {
    display::DisplayOptions options;
    options.size = {64, 32};
    const auto screen = display::open_headless(options, "asked for");
    const display::Canvas canvas = screen->begin_frame();
    const auto draw = [&canvas] {
        const render::gl::Program dome("spread.vert", "spread.frag");
        dome.use();
        glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer);
        glClearColor(0, 1, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glFinish();
    };
    draw();
    if (std::strstr(screen->renderer().c_str(), "LLVM") == nullptr) GTEST_SKIP() << "a driver without it";
    const double before_mb = resident_memory_mb();
    const std::size_t bytes = let_go_of_compilers();
    EXPECT_GT(bytes, 10U << 20U);
    EXPECT_LT(resident_memory_mb(), before_mb - 5);
    draw();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(Heap, IsTidiedAfterAVisitAndNowAndThenWhereNobodyComes) {
    using namespace std::chrono_literals;
    TimesToTidy times;
    EXPECT_FALSE(times.is_due(1, 90s));
    EXPECT_TRUE(times.is_due(5, 10min));
    EXPECT_FALSE(times.is_due(9, 19min));
    EXPECT_TRUE(times.is_due(9, 20min));
    for (base::Instant now = 20min; now < 80min; now += 1min) EXPECT_FALSE(times.is_due(9, now));
    EXPECT_TRUE(times.is_due(9, 80min));
    EXPECT_FALSE(times.is_due(9, 81min));
}

}  // namespace
}  // namespace quadrat::machine
