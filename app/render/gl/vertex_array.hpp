// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <initializer_list>

#include "render/gl/handles.hpp"

namespace quadrat::render::gl {

enum class Numbers { AsTheyAre, Normalised };
enum class Advance { PerVertex, PerInstance };

struct Attribute {
    GLuint location;
    GLint components;
    GLenum type;
    Numbers numbers;
    GLuint offset_bytes;  // within its stream's element
};

// One buffer's elements, and what they hold.
struct Stream {
    GLuint binding;
    GLsizei stride_bytes;
    Advance advance;
    std::initializer_list<Attribute> attributes;
};

// How streams are read; which buffers they come from may change from draw to draw.
class VertexArray {
  public:
    explicit VertexArray(std::initializer_list<Stream> streams);

    void bind() const { glBindVertexArray(name_.get()); }
    // The vertex array must be bound.
    void feed(GLuint binding, GLuint buffer, std::size_t offset_bytes = 0) const;
    void feed_indices(GLuint buffer) const { glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer); }

  private:
    VertexArrayName name_;
    GLsizei strides_[4]{};
};

}  // namespace quadrat::render::gl
