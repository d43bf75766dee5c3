// SPDX-License-Identifier: Apache-2.0
#include "render/gl/vertex_array.hpp"

#include <cassert>
#include <iterator>

#include "render/gl/limits.hpp"

namespace quadrat::render::gl {
namespace {

VertexArrayName new_vertex_array() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return VertexArrayName{name};
}

}  // namespace

VertexArray::VertexArray(std::initializer_list<Stream> streams) : name_(new_vertex_array()) {
    bind();
    for (const Stream& stream : streams) {
        assert(stream.binding < std::size(strides_));
        strides_[stream.binding] = stream.stride_bytes;
        glVertexBindingDivisor(stream.binding, stream.advance == Advance::PerInstance ? 1 : 0);
        for (const Attribute& a : stream.attributes) {
            limits::check_attribute(a.location);
            glEnableVertexAttribArray(a.location);
            glVertexAttribFormat(a.location, a.components, a.type,
                                 static_cast<GLboolean>(a.numbers == Numbers::Normalised), a.offset_bytes);
            glVertexAttribBinding(a.location, stream.binding);
        }
    }
    glBindVertexArray(0);
}

void VertexArray::feed(GLuint binding, GLuint buffer, std::size_t offset_bytes) const {
    glBindVertexBuffer(binding, buffer, static_cast<GLintptr>(offset_bytes), strides_[binding]);
}

}  // namespace quadrat::render::gl
