// SPDX-License-Identifier: Apache-2.0
#include "render/gl/buffer.hpp"

#include <cassert>

#include "render/gl/limits.hpp"

namespace quadrat::render::gl {
namespace {

BufferName new_buffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return BufferName{name};
}

}  // namespace

// Index buffers are written through the copy target: binding them elsewhere would change a vertex array's own.
Buffer::Buffer(GLenum target, std::size_t bytes)
    : name_(new_buffer()), target_(target == GL_ELEMENT_ARRAY_BUFFER ? GL_COPY_WRITE_BUFFER : target), bytes_(bytes) {
    glBindBuffer(target_, name_.get());
    glBufferData(target_, static_cast<GLsizeiptr>(bytes), nullptr, GL_STATIC_DRAW);
}

void Buffer::write_bytes(std::size_t offset, std::span<const std::byte> bytes) {
    assert(offset + bytes.size() <= bytes_);
    if (bytes.empty()) return;
    glBindBuffer(target_, name_.get());
    glBufferSubData(target_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

StreamBuffer::StreamBuffer(GLenum target)
    : name_(new_buffer()), target_(target == GL_ELEMENT_ARRAY_BUFFER ? GL_COPY_WRITE_BUFFER : target) {}

void StreamBuffer::fill_bytes(std::span<const std::byte> bytes) {
    glBindBuffer(target_, name_.get());
    glBufferData(target_, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STREAM_DRAW);
}

void bind_uniforms(const Buffer& buffer, GLuint binding) {
    limits::check_uniform_range(0, buffer.bytes());
    glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer.name());
}

void bind_uniforms(const StreamBuffer& buffer, GLuint binding, std::size_t offset, std::size_t size) {
    limits::check_uniform_range(offset, size);
    glBindBufferRange(GL_UNIFORM_BUFFER, binding, buffer.name(), static_cast<GLintptr>(offset),
                      static_cast<GLsizeiptr>(size));
}

}  // namespace quadrat::render::gl
