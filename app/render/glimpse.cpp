// SPDX-License-Identifier: Apache-2.0
#include "render/glimpse.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

namespace quadrat::render {
namespace {

// A picture comes in so many frames: memory that a GPU shares is slow to read, and each slice takes a millisecond or
// two.
constexpr int kFrames = 8;

}  // namespace

bool Glimpse::make(glm::ivec2 size) {
    if (size == size_) return true;
    if (framebuffer_ == 0) glGenFramebuffers(1, &framebuffer_);
    if (!colour_) {
        GLuint names[2] = {0, 0};
        glGenRenderbuffers(1, &names[0]);
        glGenBuffers(1, &names[1]);
        colour_ = gl::RenderbufferName(names[0]);
        bytes_ = gl::BufferName(names[1]);
    }
    glBindRenderbuffer(GL_RENDERBUFFER, colour_.get());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.x, size.y);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.get());
    if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return false;
    glBindBuffer(GL_PIXEL_PACK_BUFFER, bytes_.get());
    glBufferData(GL_PIXEL_PACK_BUFFER, GLsizeiptr{4} * size.x * size.y, nullptr, GL_STREAM_READ);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    size_ = size;
    return true;
}

bool Glimpse::begin(const Frame& frame, int most_width) {
    const glm::ivec2 full = turned_size(frame.size, frame.hanging);
    if (is_on_its_way_ || full.x < 1 || full.y < 1) return false;
    const int width = std::min(full.x, most_width);
    if (!make({width, std::max(1, full.y * width / full.x)})) return false;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, full.x, full.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, bytes_.get());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, frame.framebuffer);
    brought_.set();
    picture_ = mesh::Image(size_.x, size_.y, 4);
    rows_ = 0;
    is_on_its_way_ = true;
    return true;
}

std::optional<mesh::Image> Glimpse::take() {
    if (!is_on_its_way_ || !brought_.is_done_within(std::chrono::nanoseconds{0})) return std::nullopt;
    const int count = std::min((size_.y + kFrames - 1) / kFrames, size_.y - rows_);
    const GLsizeiptr row_bytes = GLsizeiptr{4} * size_.x;
    glBindBuffer(GL_PIXEL_PACK_BUFFER, bytes_.get());
    const auto* rows = static_cast<const std::uint8_t*>(
        glMapBufferRange(GL_PIXEL_PACK_BUFFER, rows_ * row_bytes, count * row_bytes, GL_MAP_READ_BIT));
    // GL has rows from the bottom.
    for (int i = 0; i < count && rows != nullptr; ++i)
        std::memcpy(picture_.pixel(0, size_.y - 1 - (rows_ + i)), rows + i * row_bytes,
                    static_cast<std::size_t>(row_bytes));
    if (rows != nullptr) glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    rows_ += count;
    if (rows != nullptr && rows_ < size_.y) return std::nullopt;
    is_on_its_way_ = false;
    return rows == nullptr ? std::nullopt : std::optional(std::exchange(picture_, {}));
}

}  // namespace quadrat::render
