// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/vec2.hpp>

#include "render/gl/texture.hpp"

namespace quadrat::render::gl {

// A picture with a depth buffer to draw it with: RGBA8, depth 24, stencil 8, as displays have them, so that what
// drivers compile for one serves both. Made when it is first needed.
class DeepTarget {
  public:
    // The framebuffer to draw a picture of this size to; 0 where this GPU cannot. What was drawn stays while the size
    // does.
    GLuint of(glm::ivec2 size);
    const Texture2D& picture() const { return picture_; }
    void let_go();  // of its memory

  private:
    GLuint framebuffer_ = 0;  // goes with its context
    Texture2D picture_;
    RenderbufferName depth_;
    bool is_whole_ = false;
};

}  // namespace quadrat::render::gl
