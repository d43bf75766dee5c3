// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>

#include "render/gl/handles.hpp"

namespace quadrat::render::gl {

// A buffer that is written once, in as many pieces as its upload takes.
class Buffer {
  public:
    Buffer() = default;  // none
    Buffer(GLenum target, std::size_t bytes);

    template <typename Element>
    void write(std::size_t first_element, std::span<const Element> elements) {
        write_bytes(first_element * sizeof(Element), std::as_bytes(elements));
    }
    GLuint name() const { return name_.get(); }
    std::size_t bytes() const { return bytes_; }

  private:
    void write_bytes(std::size_t offset, std::span<const std::byte> bytes);
    BufferName name_;
    GLenum target_ = GL_ARRAY_BUFFER;
    std::size_t bytes_ = 0;
};

// A buffer that is new every frame. The store is orphaned each time, so that no frame waits for the one before it.
class StreamBuffer {
  public:
    explicit StreamBuffer(GLenum target);

    template <typename Element>
    void fill(std::span<const Element> elements) {
        fill_bytes(std::as_bytes(elements));
    }
    GLuint name() const { return name_.get(); }

  private:
    void fill_bytes(std::span<const std::byte> bytes);
    BufferName name_;
    GLenum target_;
};

// All of it as uniform block `binding`.
void bind_uniforms(const Buffer& buffer, GLuint binding);

// Binds size bytes of it, from offset, as uniform block `binding`.
void bind_uniforms(const StreamBuffer& buffer, GLuint binding, std::size_t offset, std::size_t size);

}  // namespace quadrat::render::gl
