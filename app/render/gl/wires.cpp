// SPDX-License-Identifier: Apache-2.0
#include "render/gl/wires.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace quadrat::render::gl {
namespace {

thread_local int wires = 0;

std::size_t bytes_of_index(GLenum type) {
    return type == GL_UNSIGNED_SHORT ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
}

template <typename Index>
void append_edges(const void* triangles, std::size_t count, std::vector<std::uint32_t>& edges) {
    const auto* index = static_cast<const Index*>(triangles);
    for (std::size_t i = 0; i + 2 < count; i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            edges.push_back(index[i + k]);
            edges.push_back(index[i + (k + 1) % 3]);
        }
}

void draw_edges(GLenum index_type, std::size_t first, std::size_t count, std::size_t instances) {
    const std::size_t bytes = bytes_of_index(index_type);
    const void* triangles = glMapBufferRange(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(first * bytes),
                                             static_cast<GLsizeiptr>(count * bytes), GL_MAP_READ_BIT);
    if (triangles == nullptr) return;
    std::vector<std::uint32_t> edges;
    edges.reserve(2 * count);
    if (index_type == GL_UNSIGNED_SHORT)
        append_edges<std::uint16_t>(triangles, count, edges);
    else
        append_edges<std::uint32_t>(triangles, count, edges);
    glUnmapBuffer(GL_ELEMENT_ARRAY_BUFFER);
    GLint before = 0;
    glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &before);
    GLuint name = 0;
    glGenBuffers(1, &name);
    const BufferName lines{name};
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, name);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(edges.size() * sizeof(edges.front())), edges.data(),
                 GL_STREAM_DRAW);
    glDrawElementsInstanced(GL_LINES, static_cast<GLsizei>(edges.size()), GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(instances));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLuint>(before));
}

}  // namespace

Wires::Wires() { ++wires; }
Wires::~Wires() { --wires; }
bool Wires::are_on() { return wires > 0; }

void Wires::set_level(std::size_t level) {
    if (!are_on()) return;
    // From warm, fine, to cold, coarse.
    constexpr std::array<std::array<float, 3>, 6> kColours{{{0.95F, 0.25F, 0.15F},
                                                            {1.0F, 0.65F, 0.1F},
                                                            {0.95F, 0.95F, 0.3F},
                                                            {0.35F, 0.9F, 0.35F},
                                                            {0.3F, 0.75F, 1.0F},
                                                            {0.75F, 0.5F, 1.0F}}};
    const auto& c = kColours[std::min(level, kColours.size() - 1)];
    glUniform3f(15, c[0], c[1], c[2]);
}

void draw_triangles(GLenum index_type, std::size_t first, std::size_t count, std::size_t instances) {
    if (count == 0 || instances == 0) return;
    if (Wires::are_on()) {
        draw_edges(index_type, first, count, instances);
        return;
    }
    const std::size_t bytes = bytes_of_index(index_type);
    const auto* offset = reinterpret_cast<const void*>(first * bytes);
    if (instances == 1)
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), index_type, offset);
    else
        glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(count), index_type, offset,
                                static_cast<GLsizei>(instances));
}

}  // namespace quadrat::render::gl
