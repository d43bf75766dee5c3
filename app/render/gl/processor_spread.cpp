// SPDX-License-Identifier: Apache-2.0
#include "render/gl/processor_spread.hpp"

#include <algorithm>

#include "render/gl/limits.hpp"

namespace quadrat::render::gl {
namespace {

// Of 5 kB each, 1280 pixels wide: a band stays in a core's cache from when it is made until it is copied.
constexpr int kBandRows = 16;

std::size_t area(int width, int height) { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }

}  // namespace

void ProcessorSpread::make_room(glm::ivec2 size, bool is_window) {
    // Windows have blue first and their upper rows first, framebuffers of ours red and the lower ones: what has the
    // same order is copied as it is.
    const bool has_blue_first = is_window && limits::has_extension("GL_EXT_texture_format_BGRA8888") &&
                                limits::has_extension("GL_EXT_read_format_bgra");
    const GLenum format = has_blue_first ? GL_BGRA_EXT : GL_RGBA;
    if (size == size_ && format == format_) return;
    size_ = size;
    format_ = format;
    GLuint name = 0;
    glGenTextures(1, &name);
    enlarged_.reset(name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size.x, size.y, 0, format, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    if (source_ == 0) glGenFramebuffers(1, &source_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source_);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
    band_.resize(area(size.x, kBandRows));
}

void ProcessorSpread::show(GLuint from, glm::ivec2 drawn, GLuint to, glm::ivec2 size) {
    if (!enlargement_ || !enlargement_->is_of(drawn, size)) {
        enlargement_.emplace(drawn, size);
        drawn_.resize(area(drawn.x, drawn.y));
    }
    make_room(size, to == 0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glReadPixels(0, 0, drawn.x, drawn.y, format_, GL_UNSIGNED_BYTE, drawn_.data());
    glBindTexture(GL_TEXTURE_2D, enlarged_.get());
    enlargement_->begin(drawn_);
    const bool is_window = to == 0;
    const auto width = static_cast<std::size_t>(size.x);
    for (int y = 0; y < size.y; y += kBandRows) {
        const int rows = std::min(kBandRows, size.y - y);
        for (int i = 0; i < rows; ++i) {
            const int above = is_window ? rows - 1 - i : i;
            enlargement_->write(y + i, std::span{band_}.subspan(static_cast<std::size_t>(above) * width, width));
        }
        const int first = is_window ? size.y - y - rows : y;
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first, size.x, rows, format_, GL_UNSIGNED_BYTE, band_.data());
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    const int first = is_window ? size.y : 0;
    glBlitFramebuffer(0, first, size.x, size.y - first, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, to);
}

}  // namespace quadrat::render::gl
