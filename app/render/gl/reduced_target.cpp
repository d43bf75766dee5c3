// SPDX-License-Identifier: Apache-2.0
#include "render/gl/reduced_target.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <initializer_list>

namespace quadrat::render::gl {

ReducedTarget::ReducedTarget(SpreadBy by) : spread_("spread.vert", "spread.frag") {
    if (by == SpreadBy::Processor) processor_.emplace();
}

GLuint ReducedTarget::of(glm::ivec2 size) {
    const bool is_large_enough = size.x <= colour_.shape().width && size.y <= colour_.shape().height;
    if (is_large_enough && colour_.name() != 0) return is_whole_ ? framebuffer_ : 0;
    colour_ = Texture2D{{.width = size.x, .height = size.y, .sampling = Sampling::Flat}};
    GLuint depth = 0;
    glGenTextures(1, &depth);
    depth_.reset(depth);
    glBindTexture(GL_TEXTURE_2D, depth);
    // As displays have it: what drivers compile for one serves both.
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH24_STENCIL8, size.x, size.y);
    if (framebuffer_ == 0) glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    is_whole_ = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    return is_whole_ ? framebuffer_ : 0;
}

void ReducedTarget::show(glm::ivec2 drawn, GLuint framebuffer, glm::ivec2 size) {
    const GLenum depth = GL_DEPTH_STENCIL_ATTACHMENT;
    glInvalidateFramebuffer(GL_FRAMEBUFFER, 1, &depth);
    for (const GLenum test : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_BLEND, GL_CULL_FACE}) glDisable(test);
    if (processor_ && std::min(drawn.x, drawn.y) >= 2) return processor_->show(framebuffer_, drawn, framebuffer, size);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    // All of it is drawn over: a tiler need not fetch what was there.
    const GLenum old = framebuffer == 0 ? GL_COLOR : GL_COLOR_ATTACHMENT0;
    glInvalidateFramebuffer(GL_FRAMEBUFFER, 1, &old);
    glViewport(0, 0, size.x, size.y);
    spread(drawn, size);
}

void ReducedTarget::spread(glm::ivec2 drawn, glm::ivec2 size) const {
    spread_.use();
    const glm::vec2 shown{size};
    const glm::vec2 all{colour_.shape().width, colour_.shape().height};
    // From the middle of the first pixel to that of the last one, and half a pixel of what is shown beyond.
    const glm::vec2 step = (glm::vec2{drawn} - 1.0F) / glm::max(shown - 1.0F, glm::vec2{1});
    const glm::vec2 begin = (0.5F - 0.5F * step) / all;
    const glm::vec2 span = step * shown / all;
    glUniform4f(0, begin.x, begin.y, span.x, span.y);
    colour_.bind(0);
    glBindVertexArray(0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace quadrat::render::gl
