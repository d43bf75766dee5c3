// SPDX-License-Identifier: Apache-2.0
#include "render/gl/reduced_target.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "display/egl/offscreen_target.hpp"
#include "unit/render/gpu_fixture.hpp"

namespace quadrat::render::gl {
namespace {

class Reduced : public Gpu {
  protected:
    // Rectangles of many colours, in a part of them that many pixels large, as they are shown.
    static std::vector<std::uint8_t> shown(ReducedTarget& target, glm::ivec2 drawn, glm::ivec2 size) {
        const display::OffscreenTarget screen({size.x, size.y});
        glBindFramebuffer(GL_FRAMEBUFFER, target.of(size));
        glClearColor(1, 0, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT);  // what lies beyond is never seen
        glEnable(GL_SCISSOR_TEST);
        for (int i = 0; i < 60; ++i) {
            const int x = i * 37 % drawn.x;
            const int y = i * 23 % drawn.y;
            glScissor(x, y, std::min(5 + i % 9, drawn.x - x), std::min(4 + i % 7, drawn.y - y));
            glClearColor(static_cast<float>(i % 3) / 2, static_cast<float>(i % 4) / 3, static_cast<float>(i % 5) / 8,
                         1);
            glClear(GL_COLOR_BUFFER_BIT);
        }
        glScissor(0, 0, drawn.x, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        target.show(drawn, screen.framebuffer(), size);
        std::vector<std::uint8_t> pixels(static_cast<std::size_t>(size.x * size.y * 4));
        glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        EXPECT_FALSE(glIsEnabled(GL_SCISSOR_TEST));
        return pixels;
    }
};

TEST_F(Reduced, IsSpreadAlikeByShaderAndProcessor) {
    ReducedTarget by_shader(ReducedTarget::SpreadBy::Shader);
    ReducedTarget by_processor(ReducedTarget::SpreadBy::Processor);
    // Another size, another share, and back: what is kept from frame to frame is of the right size.
    const glm::ivec2 sizes[][2] = {
        {{48, 27}, {96, 54}}, {{50, 40}, {200, 160}}, {{61, 33}, {96, 54}}, {{48, 27}, {96, 54}}, {{1, 9}, {3, 17}}};
    for (const auto& [drawn, size] : sizes) {
        const auto expected = shown(by_shader, drawn, size);
        const auto pixels = shown(by_processor, drawn, size);
        int most = 0;
        for (std::size_t i = 0; i < pixels.size(); ++i) most = std::max(most, std::abs(pixels[i] - expected[i]));
        EXPECT_LE(most, 3) << drawn.x << "x" << drawn.y << " to " << size.x << "x" << size.y;
        EXPECT_NE(*std::ranges::max_element(pixels), *std::ranges::min_element(pixels));
    }
}

}  // namespace
}  // namespace quadrat::render::gl
