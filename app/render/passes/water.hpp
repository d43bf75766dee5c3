// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/texture.hpp"
#include "render/gl/vertex_array.hpp"

namespace quadrat::render::passes {

// The sea at y = 0, from under the eye to the horizon.
class WaterPass {
  public:
    WaterPass();
    void draw(const gl::Texture2D& ground) const;  // its alpha: how deep the water over it looks
    std::size_t triangles() const { return index_count_ / 3; }

  private:
    gl::Program program_;
    gl::VertexArray vertices_;
    gl::Buffer rings_;
    gl::Buffer indices_;
    gl::Texture2D ripples_;
    std::size_t index_count_ = 0;
};

}  // namespace quadrat::render::passes
