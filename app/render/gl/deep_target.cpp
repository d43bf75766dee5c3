// SPDX-License-Identifier: Apache-2.0
#include "render/gl/deep_target.hpp"

namespace quadrat::render::gl {

GLuint DeepTarget::of(glm::ivec2 size) {
    const bool is_of_size =
        picture_.name() != 0 && picture_.shape().width == size.x && picture_.shape().height == size.y;
    if (is_of_size) return is_whole_ ? framebuffer_ : 0;
    picture_ = Texture2D{{.width = size.x, .height = size.y, .sampling = Sampling::Flat}};
    GLuint depth = 0;
    glGenRenderbuffers(1, &depth);
    depth_.reset(depth);
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, size.x, size.y);
    if (framebuffer_ == 0) glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_.name(), 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth);
    is_whole_ = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    return is_whole_ ? framebuffer_ : 0;
}

void DeepTarget::let_go() {
    picture_ = {};
    depth_.reset();
    is_whole_ = false;
}

}  // namespace quadrat::render::gl
