// SPDX-License-Identifier: Apache-2.0
#include "display/egl/offscreen_target.hpp"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include "base/error.hpp"

namespace quadrat::display {
namespace {

GLuint renderbuffer(GLenum format, Size size) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, format, size.width, size.height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    return name;
}

void free_target(GLuint framebuffer, GLuint colour, GLuint depth) {
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(1, &colour);
    glDeleteRenderbuffers(1, &depth);
}

}  // namespace

OffscreenTarget::OffscreenTarget(Size size) : size_(size) {
    colour_ = renderbuffer(GL_RGBA8, size);
    depth_ = renderbuffer(GL_DEPTH24_STENCIL8, size);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    free_target(framebuffer_, colour_, depth_);
    throw base::InputError(
        fmt::format("display size {}x{}: this GPU cannot draw into it (status 0x{:x}); choose a smaller one",
                    size.width, size.height, status));
}

OffscreenTarget::~OffscreenTarget() { free_target(framebuffer_, colour_, depth_); }

}  // namespace quadrat::display
