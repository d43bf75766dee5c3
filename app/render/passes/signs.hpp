// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/vertex_array.hpp"

namespace quadrat::render::passes {

struct FlatSign {
    glm::vec2 low_px{0};  // of its bottom left corner, from the target's
    glm::vec2 size_px{0};
    const gl::Texture2D* picture = nullptr;  // none: a plain rectangle
    glm::vec4 colour{1};                     // not premultiplied
    float corner_radius_px = 0;
    float border_px = 0;  // more than 0: only this border
};

// Letters, frames and prompts over the views, in order, blended premultiplied.
class SignsPass {
  public:
    SignsPass();
    // Laid out on a picture of this size; the matrix turns its clip coordinates to the target's.
    void draw(std::span<const FlatSign> signs, glm::ivec2 upright_px,
              const glm::mat2& target_from_upright = glm::mat2{1});

  private:
    gl::Program plain_;
    gl::Program picture_;
    gl::VertexArray vertices_;
    gl::StreamBuffer corners_;
};

}  // namespace quadrat::render::passes
