// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "render/choose/falling.hpp"
#include "render/choose/view_block.hpp"
#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/vertex_array.hpp"
#include "render/gl/work.hpp"
#include "scene/sky.hpp"

namespace quadrat::render::passes {

// Rain and snow about the eye, blended over all else; they cost nothing when nothing falls.
class FallingPass {
  public:
    FallingPass();
    // In less detail fewer drops fall, each wider: as much light comes through them.
    gl::Work draw(const scene::Precipitation& what, const choose::ViewBlock& view, float pixels_per_radian,
                  float share) const;

  private:
    gl::Program program_;
    gl::VertexArray vertices_;
    gl::Buffer drops_;
    gl::Buffer indices_;
};

}  // namespace quadrat::render::passes
