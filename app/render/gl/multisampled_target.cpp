// SPDX-License-Identifier: Apache-2.0
#include "render/gl/multisampled_target.hpp"

#include <initializer_list>

namespace quadrat::render::gl {
namespace {

constexpr int kSamples = 4;  // what a Raspberry Pi has, and no more

// A resolve is between pixels of one kind.
bool has_alpha(GLuint framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    GLint bits = 0;
    const GLenum colour = framebuffer == 0 ? GL_BACK : GL_COLOR_ATTACHMENT0;
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, colour, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE, &bits);
    return bits > 0;
}

RenderbufferName storage(GLenum format, glm::ivec2 size, int samples) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.x, size.y);
    return RenderbufferName(name);
}

void blit(GLuint from, GLuint to, glm::ivec2 size) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace

GLuint MultisampledTarget::of(glm::ivec2 size, int samples, GLuint shown) {
    if (size == size_ && samples == samples_) return is_whole_ ? framebuffer_ : 0;
    size_ = size;
    samples_ = samples;
    is_whole_ = make(size, samples, shown);
    if (!is_whole_) {
        colour_.reset();
        depth_.reset();
    }
    return is_whole_ ? framebuffer_ : 0;
}

// Whether it can be resolved is only known once it was: a driver may see two kinds where we see one.
bool MultisampledTarget::make(glm::ivec2 size, int samples, GLuint shown) {
    while (glGetError() != GL_NO_ERROR) continue;
    colour_ = storage(has_alpha(shown) ? GL_RGBA8 : GL_RGB8, size, samples);
    depth_ = storage(GL_DEPTH24_STENCIL8, size, samples);
    if (framebuffer_ == 0) glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.get());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_.get());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return false;
    glDisable(GL_SCISSOR_TEST);
    glClear(GL_COLOR_BUFFER_BIT);
    blit(framebuffer_, shown, size);
    return glGetError() == GL_NO_ERROR;
}

void MultisampledTarget::resolve(GLuint shown) {
    const GLenum depth = GL_DEPTH_STENCIL_ATTACHMENT;
    glInvalidateFramebuffer(GL_FRAMEBUFFER, 1, &depth);
    for (const GLenum test : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_BLEND, GL_CULL_FACE}) glDisable(test);
    blit(framebuffer_, shown, size_);
    const GLenum samples = GL_COLOR_ATTACHMENT0;
    glInvalidateFramebuffer(GL_READ_FRAMEBUFFER, 1, &samples);
    glBindFramebuffer(GL_FRAMEBUFFER, shown);
}

void MultisampledTarget::let_go() {
    colour_.reset();
    depth_.reset();
    size_ = {0, 0};
    samples_ = 0;
    is_whole_ = false;
}

int most_samples(bool is_on_processor) {
    GLint samples = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &samples);
    return !is_on_processor && samples >= kSamples ? kSamples : 1;
}

}  // namespace quadrat::render::gl
