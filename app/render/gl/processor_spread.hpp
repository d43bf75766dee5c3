// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "render/gl/enlargement.hpp"
#include "render/gl/handles.hpp"

namespace quadrat::render::gl {

// A small framebuffer spread over a larger one by the processor, for drivers that are on it themselves: all that was
// drawn is waited for, read, enlarged, and copied, which takes less of the processor's time than a shader's turn at
// every pixel.
class ProcessorSpread {
  public:
    // Both of 8 bits a channel; the lower left corner of one over all of the other, which is left bound. drawn has at
    // least 2 pixels a side, and no more than size.
    void show(GLuint from, glm::ivec2 drawn, GLuint to, glm::ivec2 size);

  private:
    void make_room(glm::ivec2 size, bool is_window);

    std::optional<Enlargement> enlargement_;
    std::vector<std::uint32_t> drawn_;
    std::vector<std::uint32_t> band_;
    TextureName enlarged_;
    glm::ivec2 size_{0};
    GLenum format_ = GL_RGBA;
    GLuint source_ = 0;  // a framebuffer of enlarged_, which goes with its context
};

}  // namespace quadrat::render::gl
