// SPDX-License-Identifier: Apache-2.0
#include "render/gl/reduced_target.hpp"

namespace quadrat::render::gl {
namespace {

TextureName attachment(GLenum format, glm::ivec2 size) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, size.x, size.y);
    return TextureName{name};
}

}  // namespace

GLuint ReducedTarget::of(glm::ivec2 size) {
    const bool is_large_enough = size.x <= size_.x && size.y <= size_.y;
    if (is_large_enough) return is_whole_ ? framebuffer_ : 0;
    size_ = size;
    colour_ = attachment(GL_RGBA8, size);
    depth_ = attachment(GL_DEPTH_COMPONENT24, size);
    if (framebuffer_ == 0) glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.get(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.get(), 0);
    is_whole_ = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    return is_whole_ ? framebuffer_ : 0;
}

void ReducedTarget::show(glm::ivec2 drawn, GLuint framebuffer, glm::ivec2 size) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    const GLenum depth = GL_DEPTH_ATTACHMENT;
    glInvalidateFramebuffer(GL_READ_FRAMEBUFFER, 1, &depth);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, drawn.x, drawn.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

}  // namespace quadrat::render::gl
