// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>

#include "render/gl/handles.hpp"

// Triangles as their edges, in the colour of their level of detail: for whoever develops. Like the rest of GL's state,
// what is set here holds for the context's thread until it is set again.
namespace quadrat::render::gl {

// While one lives, programs draw in one colour and draw_triangles() draws edges. Reads indices back: slow.
class Wires {
  public:
    Wires();
    ~Wires();
    Wires(const Wires&) = delete;
    Wires& operator=(const Wires&) = delete;

    static bool are_on();
    // Of what is drawn next with the program in use, 0 finest. Nothing happens while wires are off.
    static void set_level(std::size_t level);
};

// Of the index buffer that is bound: GL_UNSIGNED_INT or GL_UNSIGNED_SHORT, from the first-th on.
void draw_triangles(GLenum index_type, std::size_t first, std::size_t count, std::size_t instances = 1);

}  // namespace quadrat::render::gl
