// SPDX-License-Identifier: Apache-2.0
#include "render/gl/texture_target.hpp"

namespace quadrat::render::gl {

TextureTarget::Drawing::Drawing(GLuint framebuffer, const Texture2D& texture) {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_before_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
    glViewport(0, 0, texture.shape().width, texture.shape().height);
    for (const GLenum test : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_BLEND, GL_CULL_FACE}) glDisable(test);
}

TextureTarget::Drawing::~Drawing() {
    // A picture that stays attached would not be freed.
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_before_));
}

void TextureTarget::Drawing::copy_to(const Texture2D& texture, int level, int first_row, int rows) const {
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glCopyTexSubImage2D(GL_TEXTURE_2D, level, 0, first_row, 0, 0, texture.width(level), rows);
}

}  // namespace quadrat::render::gl
